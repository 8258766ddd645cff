#pragma once

#include <span>

#include "core/physics/contact/contact.h"
#include "core/physics/solver.h"
#include "core/world/world.h"
#include "core/world/world_delta.h"

namespace kerf {

// Puts bodies to sleep and wakes them. A body is restless until it has been slower than the limits for half
// a second. A restless body keeps awake the bodies that it touches, those that touch them, and all bodies
// that joints connect to one of these; all others sleep, so that a rattling piece does not keep a whole
// pile awake. `memory` holds the bodies that touched before they fell asleep. Returns true if a body woke.
bool update_sleep(std::span<MovingBody> bodies, std::span<const TouchingPair> pairs,
                  std::span<const BodyJoint> joints, const ContactMemory& memory, double seconds);

// Counts the ticks for which bodies were slow, after a tick. Bodies that turn on a joint must be much slower,
// because they turn slowly at the ends of a swing. Bodies that are pushed out of each other are not slow.
void count_quiet(std::span<MovingBody> bodies, std::span<const TouchingPair> pairs,
                 std::span<const BodyJoint> joints);

// Updates World::contact_memory() after a change that was not made by a tick. Removes the contacts of a
// body if its faces or mass changed, or if it was moved, created, destroyed, hidden or shown, since its
// points and chords differ or are elsewhere. Wakes these bodies and the bodies that touched them, which may
// have lost support; a change of gravity wakes all. O(pairs that are near each other + bodies).
void forget_contacts(World& world, const Delta& delta);
// Removes the contacts of these bodies, which may be in any order.
void forget_contacts(World& world, std::vector<BodyId> bodies);

// Reduces the memory of all pairs to their bodies and whether they touch or intersect: the data in a
// journal (see BodyStates). Bodies continue equally well, but not bit-identically, so replay must call this
// at the same point.
void forget_details(World& world);

}  // namespace kerf
