#pragma once

#include "ui/editor/editor_state.h"

namespace kerf {

// What the left button does now, the last message, faces, pieces and frame time.
void draw_status_bar(EditorState& state);

}  // namespace kerf
