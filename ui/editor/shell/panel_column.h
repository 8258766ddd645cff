#pragma once

#include <span>
#include <vector>

#include "ui/editor/shared/settings.h"
#include "ui/editor/shared/user_input.h"
#include "ui/editor/shared/viewport.h"
#include "ui/editor/shell/catalogue.h"
#include "ui/window/layout.h"

namespace kerf {

// Draws a small button at the right end of the line of the last widget, which ends at `right` (in the
// coordinates of the current window). Its menu, which a right click on that widget opens too, offers the
// places of a panel. Precondition: the current ImGui ids are those of the panel.
void draw_dock_button(const char* panel, float right, PanelPlaces& places);

// Returns the height of the row of tabs, screen coordinates. Precondition of both: an ImGui frame has begun.
float tab_bar_height();

// Draws the tabs of the sidebar side by side over the current window, each an icon over a word. A click
// brings a tab to the front.
void draw_tab_bar(const ViewState& view, PanelPlaces& places);

// Returns one action per tab, which brings it to the front. The places must outlive them.
std::vector<UserAction> tab_actions(PanelPlaces& places);

// Draws the panels in their places: the sidebar under the selected tab, the second column, the strip, and
// floating windows. `panels` is in display order; changes by the user are stored in the places and the
// settings.
void draw_panel_areas(const ViewState& view, std::span<const Panel> panels, PanelPlaces& places,
                      Settings& settings);

// Returns one action per panel, which shows or folds it. The places must outlive them.
std::vector<UserAction> panel_actions(std::span<const Panel> panels, PanelPlaces& places);

// Returns the current sizes of the areas of panels.
PanelSizes panel_sizes(const PanelPlaces& places, const Settings& settings);

// Draws the edges of the areas of panels and the middle of a split view, which the user can drag.
void draw_splitters(const ViewState& view, Settings& settings);

}  // namespace kerf
