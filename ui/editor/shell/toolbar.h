#pragma once

#include <span>

#include "ui/editor/shared/user_input.h"
#include "ui/window/layout.h"

namespace kerf {

// Draws the tools as icons at the left edge of the viewport, the active one lit; each is a landmark by the
// id of its action. Hovering shows name, key and purpose. Omitted if the viewport is too low.
void draw_toolbar(const Area& viewport, std::span<const UserAction> actions);

}  // namespace kerf
