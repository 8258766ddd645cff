#pragma once

#include "ui/editor/editor_state.h"

namespace kerf {

// What is drawn over the picture.
void draw_view_panel(EditorState& state);

}  // namespace kerf
