#pragma once

#include <span>

#include "ui/editor/shared/settings.h"
#include "ui/editor/shell/feature.h"
#include "ui/window/layout.h"

namespace kerf {

// Draws the panels one below the other, those of the same title under one header; which are unfolded is in
// the settings.
void draw_panel_column(const Area& area, std::span<const Panel> panels, Settings& settings);

// One action for each title, which unfolds or folds it. The settings must outlive them.
std::vector<UserAction> panel_actions(std::span<const Panel> panels, Settings& settings);

// Lets the user drag the left edge of the column and the middle of a split picture.
void draw_splitters(const Layout& layout, Settings& settings);

}  // namespace kerf
