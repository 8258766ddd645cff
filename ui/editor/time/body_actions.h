#pragma once

#include "ui/editor/shared/workspace.h"
#include "ui/editor/time/play_state.h"

namespace kerf {

// Play and pause, single ticks, speeds, gravity and pins. Both must outlive them.
std::vector<UserAction> body_actions(Workspace& on, PlayState& play);

// Pins the chosen pieces where they are, or lets them move again; they stay chosen.
void ask_to_pin(Workspace& on, bool pinned);

// The reason why no piece can be pinned or unpinned, or null.
const char* why_no_pin(const ViewState& view);
// Whether all chosen pieces are pinned. Precondition: the pieces are those of the world.
bool chosen_are_pinned(const World& world, const ViewState& view);

// Gravity on or off. Without gravity there is a ground only if +Y points upwards. The value is that of the
// earth, and the ground lies where it is drawn.
SetEnvironment with_gravity(const World& world, const FileFrame& frame, bool on);

}  // namespace kerf
