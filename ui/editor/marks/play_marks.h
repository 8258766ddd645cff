#pragma once

#include "core/world/world.h"
#include "ui/editor/play/play_state.h"
#include "ui/editor/tools/hand.h"
#include "ui/editor/view/view_state.h"

namespace kerf {

// Draws at the upper edge of the first half of the picture whether time passes, how fast, and how long it has
// passed: "Playing 1/2x  3.4 s". Draws nothing until bodies moved for the first time.
void draw_play_badge(const PlayState& play, const World& world, const ViewState& view);

// Draws the spring that the user pulls a piece by, if there is one.
void draw_spring(const World& world, const ViewState& view, const Hand& hand);

}  // namespace kerf
