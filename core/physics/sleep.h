#pragma once

#include <span>

#include "core/physics/contact/contact.h"
#include "core/physics/joint_constraints.h"

namespace kerf {

// Puts bodies to sleep and wakes them. A body is restless until it has been slower than the limits for half a
// second. A restless body keeps awake the bodies that it touches, those that touch them, and all bodies that
// joints connect to one of these; all others sleep, so that a piece which rattles does not keep a whole pile
// awake. `memory` tells of bodies that touched before they fell asleep. Returns whether a body woke.
bool update_sleep(std::span<MovingBody> bodies, std::span<const TouchingPair> pairs,
                  std::span<const BodyJoint> joints, const ContactMemory& memory, double seconds);

// Counts the ticks for which bodies were slow, after a tick. Bodies that turn on a joint must be much slower,
// because they turn slowly at the ends of a swing. Bodies that are pushed out of each other are not slow.
void count_quiet(std::span<MovingBody> bodies, std::span<const TouchingPair> pairs,
                 std::span<const BodyJoint> joints);

}  // namespace kerf
