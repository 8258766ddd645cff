#pragma once

#include "core/world/spring.h"
#include "core/world/world.h"
#include "ui/editor/shared/view_state.h"
#include "ui/editor/time/play_state.h"

namespace kerf {

// Draws at the upper edge of the first half of the picture whether time passes, how fast, and how long it has
// passed: "Playing 1/2x  3.4 s". Draws nothing until bodies moved for the first time.
void draw_play_badge(const PlayState& play, const World& world, const ViewState& view);

// Draws the spring that the user pulls a piece by.
void draw_spring(const Spring& spring, const World& world, const ViewState& view);

}  // namespace kerf
