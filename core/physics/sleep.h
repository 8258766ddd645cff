#pragma once

#include <span>

#include "core/physics/contact/contact.h"
#include "core/physics/solver.h"
#include "core/world/world.h"
#include "core/world/world_delta.h"

namespace kerf {

// Puts bodies to sleep and wakes them. A body is restless until it has been slower than the limits for half a
// second. A restless body keeps awake the bodies that it touches, the bodies that touch those, and all bodies
// connected to any of these by joints. All other bodies sleep, so that a rattling piece does not keep a whole
// pile awake. `memory` holds the pairs that touched before they fell asleep. Returns true if a body woke.
bool update_sleep(std::span<MovingBody> bodies, std::span<const TouchingPair> pairs,
                  std::span<const BodyJoint> joints, const ContactMemory& memory, double seconds);

// Updates Motion::quiet after a tick: increments it for slow bodies, resets it for others. Bodies that turn
// on a joint must be much slower to count, because they are slow at the ends of a swing. Bodies that are
// being pushed out of each other do not count as slow.
void count_quiet(std::span<MovingBody> bodies, std::span<const TouchingPair> pairs,
                 std::span<const BodyJoint> joints);

// Updates World::contact_memory() after a change that was not made by a tick. Removes the contacts of a body
// if its faces or mass changed, or if it was moved, created, destroyed, hidden or shown, because its contact
// points and chords have changed. Wakes these bodies and the bodies that touched them, which may have lost
// support; a change of gravity wakes all bodies. O(pairs that are near each other + bodies).
void forget_contacts(World& world, const Delta& delta);
// Removes the contacts of these bodies, which may be in any order.
void forget_contacts(World& world, std::vector<BodyId> bodies);

// Reduces the contact memory of all pairs to the data in a journal: the bodies, and whether they touch or
// intersect (see NearPair). Motion continues plausibly but not bit-identically, so a replay must call this at
// the same tick.
void forget_details(World& world);

}  // namespace kerf
