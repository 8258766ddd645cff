#pragma once

#include <functional>

#include "ui/editor/frame/user_action.h"
#include "ui/editor/play/play_state.h"
#include "ui/editor/view/view_state.h"
#include "ui/editor/work/open_work.h"
#include "ui/editor/work/requests.h"

namespace kerf {

// What the actions of moving bodies work on.
struct BodyParts {
  PlayState& play;
  const OpenWork& work;
  const ViewState& view;
  Requests& requests;
  Message& message;
  std::function<const char*()> why_no_play;  // a sentence why time stands still, or null
};

// Play and pause, single ticks, speeds, gravity and pins. The parts must outlive them.
std::vector<UserAction> body_actions(const BodyParts& on);

// The reason why no piece can be pinned or unpinned, or null.
const char* why_no_pin(const ViewState& view);
// Whether all chosen pieces are pinned. Precondition: the pieces are those of the world.
bool chosen_are_pinned(const World& world, const ViewState& view);

// Gravity on or off. Without gravity there is a ground only if +Y points upwards. The value is that of the
// earth, and the ground lies where it is drawn.
SetSurroundings with_gravity(const World& world, const FileFrame& frame, bool on);

}  // namespace kerf
