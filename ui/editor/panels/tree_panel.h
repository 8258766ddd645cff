#pragma once

#include "ui/editor/editor_state.h"

namespace kerf {

// Which boxes of the tree are drawn, and what the last step made of the tree.
void draw_tree_panel(EditorState& state);

}  // namespace kerf
