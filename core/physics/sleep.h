#pragma once

#include <span>
#include <vector>

#include "core/physics/contact/touching_pair.h"
#include "core/physics/joint_constraints.h"
#include "core/world/contact_memory.h"

namespace kerf {

// Puts bodies to sleep and wakes them. Bodies that touch or that joints connect form an island, which sleeps
// as a whole once each of them has been slower than the limits for half a second, and wakes as a whole.
// `memory` tells of bodies that touched before they fell asleep. Returns whether a body woke.
bool update_sleep(std::span<MovingBody> bodies, std::span<const TouchingPair> pairs,
                  std::span<const BodyJoint> joints, const ContactMemory& memory, double seconds);

// Counts the ticks for which bodies were slow, after a tick. Bodies that turn on a joint must be much slower,
// because they turn slowly at the ends of a swing.
void count_quiet(std::span<MovingBody> bodies, std::span<const BodyJoint> joints);

}  // namespace kerf
