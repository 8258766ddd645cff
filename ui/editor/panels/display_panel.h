#pragma once

#include "ui/editor/editor_state.h"

namespace kerf {

// Theme, size of the text, palette.
void draw_display_panel(EditorState& state);

}  // namespace kerf
