#pragma once

#include <string>

#include "core/world/spring.h"
#include "core/world/world.h"
#include "ui/editor/shared/picture/badges.h"
#include "ui/editor/shared/picture/view_state.h"
#include "ui/editor/time/play_state.h"
#include "ui/editor/time/reached_speed.h"

namespace kerf {

// The speed at which time is to pass, and the one that is reached where that is clearly less: "1x",
// "0.12x of 1x".
std::string speed_text(const PlayState& play, const ReachedSpeed& reached);

// Draws at the upper edge of the first half of the picture whether time passes, how fast, and how long it has
// passed: "Playing 1/2x  3.4 s".
void draw_play_badge(const PlayState& play, const ReachedSpeed& reached, const World& world,
                     const ViewState& view, Badges& badges);

// Draws the spring that the user pulls a piece by.
void draw_spring(const Spring& spring, const World& world, const ViewState& view);

}  // namespace kerf
