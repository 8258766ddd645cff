#pragma once

#include <string>

#include "core/world/rigid_body.h"
#include "core/world/world.h"
#include "ui/editor/shared/viewport.h"
#include "ui/editor/shared/workspace.h"
#include "ui/editor/time/time_flow.h"

namespace kerf {

// Play and pause, single ticks, speeds, gravity and pins. Both must outlive them.
std::vector<UserAction> body_actions(Workspace& workspace, PlayState& play);

// Pins the chosen pieces where they are, or lets them move again; they stay chosen.
void ask_to_pin(Workspace& workspace, bool pinned);

// The reason why no piece can be pinned or unpinned, or null.
const char* why_no_pin(const ViewState& view);
// Whether all chosen pieces are pinned. Precondition: the pieces are those of the world.
bool chosen_are_pinned(const World& world, const ViewState& view);

// Gravity on or off. Without gravity there is a ground only if +Y points upwards. The value is that of the
// earth, and the ground lies where it is drawn.
SetEnvironment with_gravity(const World& world, const FileFrame& frame, bool on);

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
