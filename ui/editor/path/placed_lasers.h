#pragma once

#include "ui/editor/path/emitter.h"
#include "ui/editor/path/path_tool.h"
#include "ui/editor/path/path_work.h"

namespace kerf {

// The lasers that are set up in the scene, beside the one that the pointer holds.
struct PlacedLasers {
  PathWork path;
  PathTool path_tool;
  bool at_panel_resolution = false;  // the path is run so, and not as kerf cut --path does
  Emitter emitter;
};

}  // namespace kerf
