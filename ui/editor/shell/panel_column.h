#pragma once

#include <span>
#include <vector>

#include "ui/editor/shared/feature.h"
#include "ui/editor/shared/settings.h"
#include "ui/editor/shared/user_input.h"
#include "ui/window/layout.h"

namespace kerf {

// Draws a small button at the right end of the line of the last widget, which ends at `right` (in the
// coordinates of the window that is being drawn). Its menu, which a right click on that widget opens, too,
// offers the places in which a panel can be shown. Precondition: the ids in use are the panel's own.
void draw_dock_button(const char* title, float right, PanelPlaces& places);

// The height of the row of tabs, in screen coordinates. Precondition of both: an ImGui frame has begun.
float tab_bar_height();

// Draws the tabs of the column of panels side by side over the window that is being drawn: an icon over a
// word each. A click brings a tab to the front.
void draw_tab_bar(PanelPlaces& places);

// One action for each tab, which brings it to the front. The places must outlive them.
std::vector<UserAction> tab_actions(PanelPlaces& places);

// Draws the panels where they are: in the column under the chosen tab, in the second column, in the strip,
// and in windows of their own. Those of the same title are one panel. `panels` is in their order; what the
// user folds, docks and moves is kept in the places and the settings.
void draw_panel_areas(const Layout& layout, std::span<const Panel> panels, PanelPlaces& places,
                      Settings& settings);

// One action for each title, which shows or folds it. The places must outlive them.
std::vector<UserAction> panel_actions(std::span<const Panel> panels, PanelPlaces& places);

// The sizes of the areas that the panels take at the moment.
PanelSizes panel_sizes(const PanelPlaces& places, const Settings& settings);

// Lets the user drag the edges of the areas of panels and the middle of a split picture.
void draw_splitters(const Layout& layout, Settings& settings);

}  // namespace kerf
