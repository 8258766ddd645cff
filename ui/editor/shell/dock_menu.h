#pragma once

#include "ui/editor/shared/settings/panel_places.h"

namespace kerf {

// Draws a small button at the right end of the line of the last widget, which ends at `right` (in the
// coordinates of the window that is being drawn). Its menu, which a right click on that widget opens, too,
// offers the places in which a panel can be shown. Precondition: the ids in use are the panel's own.
void draw_dock_button(const char* title, float right, PanelPlaces& places);

}  // namespace kerf
