#pragma once

#include <span>

#include "ui/editor/shared/user_action.h"

namespace kerf {

// Draws the menus of a list of actions; those of one menu stand together in the list.
void draw_menu_bar(std::span<const UserAction> actions);

}  // namespace kerf
