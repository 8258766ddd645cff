#pragma once

#include "core/world/world.h"
#include "ui/editor/view/view_state.h"
#include "ui/screen/shadow_figures.h"

namespace kerf {

// The lights and how their shadows are cast. `bounds` are those of the world.
void draw_light_panel(ViewState& view, const World::Bounds& bounds, const ShadowFigures& figures);

}  // namespace kerf
