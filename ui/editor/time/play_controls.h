#pragma once

#include <string>

#include "core/world/rigid_body.h"
#include "core/world/world.h"
#include "ui/editor/shared/viewport.h"
#include "ui/editor/shared/workspace.h"
#include "ui/editor/time/time_flow.h"

namespace kerf {

// Actions for play and pause, single ticks, speed, gravity and pins. Both arguments must outlive them.
std::vector<UserAction> body_actions(Workspace& workspace, PlayState& play);

// Pins the selected pieces, or releases them. The selection is kept.
void request_pin(Workspace& workspace, bool pinned);

// Returns why no piece can be pinned or released, as a sentence, or null.
const char* pin_disabled_reason(const ViewState& view);
// Returns true if all selected pieces are pinned. Precondition: the pieces are those of the world.
bool selected_are_pinned(const World& world, const ViewState& view);

// Returns the command that switches gravity on or off. Its value is that of the Earth, and the ground lies
// where it is drawn. Without gravity there is a ground only if +Y points upwards.
SetEnvironment with_gravity(const World& world, const FileFrame& frame, bool on);

// Returns the set speed, with the actual one if that is clearly lower: "1x", "0.12x of 1x".
std::string speed_text(const PlayState& play, const ReachedSpeed& reached);

// Draws the state at the upper edge of the first half, with speed and elapsed time: "Playing 1/2x  3.4 s".
void draw_play_badge(const PlayState& play, const ReachedSpeed& reached, const World& world,
                     const ViewState& view, Badges& badges);

void draw_spring(const Spring& spring, const World& world, const ViewState& view);

}  // namespace kerf
