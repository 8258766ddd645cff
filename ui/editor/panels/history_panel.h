#pragma once

#include "ui/editor/editor_state.h"

namespace kerf {

// What was done, each step in words with the memory that going back holds, and the way to any of them.
void draw_history_panel(EditorState& state);

}  // namespace kerf
