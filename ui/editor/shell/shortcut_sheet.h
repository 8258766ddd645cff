#pragma once

#include <span>

#include "ui/editor/shared/user_action.h"

namespace kerf {

// Draws the window that lists all gestures and keys while `shown`; its button closes it.
void draw_shortcut_sheet(bool& shown, std::span<const UserAction> actions, std::span<const Gesture> gestures);

}  // namespace kerf
