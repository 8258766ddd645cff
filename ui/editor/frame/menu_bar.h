#pragma once

#include "ui/editor/editor_state.h"

namespace kerf {

// The menus, from the table of actions.
void draw_menu_bar(EditorState& state);

}  // namespace kerf
