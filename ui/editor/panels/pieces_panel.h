#pragma once

#include "ui/editor/editor_state.h"

namespace kerf {

// The pieces: choose, show, hide, draw apart, export.
void draw_pieces_panel(EditorState& state);

}  // namespace kerf
