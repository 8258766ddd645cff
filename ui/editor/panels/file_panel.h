#pragma once

#include "ui/editor/editor_state.h"

namespace kerf {

// What the open files held and what was repaired in them.
void draw_file_panel(EditorState& state);

}  // namespace kerf
