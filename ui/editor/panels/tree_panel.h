#pragma once

#include "core/world/world.h"
#include "ui/editor/figures/figures.h"
#include "ui/editor/view/settings.h"
#include "ui/editor/view/view_state.h"

namespace kerf {

// Which boxes of the trees are drawn, and how large the trees are.
void draw_tree_panel(ViewState& view, const World& world, Settings& settings, const ShownFigures& shown);

}  // namespace kerf
