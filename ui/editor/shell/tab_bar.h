#pragma once

#include <vector>

#include "ui/editor/shared/settings/panel_places.h"
#include "ui/editor/shared/user_action.h"

namespace kerf {

// The height of the row of tabs, in screen coordinates. Precondition of both: an ImGui frame has begun.
float tab_bar_height();

// Draws the tabs of the column of panels side by side over the window that is being drawn: an icon over a
// word each. A click brings a tab to the front.
void draw_tab_bar(PanelPlaces& places);

// One action for each tab, which brings it to the front. The places must outlive them.
std::vector<UserAction> tab_actions(PanelPlaces& places);

}  // namespace kerf
