#pragma once

#include "core/mesh/files/file_frame.h"
#include "ui/editor/shared/laser/laser_controls.h"

namespace kerf {

// The radius of the beam, and the unit that it is shown in.
struct ShownRadius {
  double length;
  FileUnit unit;
};

// Rows of a panel for a resolution. Returns whether anything changed.
bool resolution_rows(ResolutionControls& to, const ShownRadius& radius);

}  // namespace kerf
