#pragma once

#include "ui/editor/editor_state.h"

namespace kerf {

// What steps take, stage by stage, what they change and send, and where memory goes.
void draw_statistics_panel(EditorState& state);

}  // namespace kerf
