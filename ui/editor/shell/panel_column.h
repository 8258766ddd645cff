#pragma once

#include <span>

#include "ui/editor/shared/settings/panel_places.h"
#include "ui/editor/shell/feature.h"
#include "ui/window/layout.h"

namespace kerf {

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
