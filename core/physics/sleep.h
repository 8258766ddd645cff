#pragma once

#include <span>

#include "core/physics/contact/contact.h"
#include "core/physics/solver.h"
#include "core/world/world.h"
#include "core/world/world_delta.h"

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

// Makes World::contact_memory() follow a change that was made by anything but a tick: what is known of the
// contacts of a body is forgotten if its faces changed, if it was moved, or if it came, went, got another
// mass, was hidden or shown, for its points and chords are others or elsewhere. These bodies wake, and so do
// the bodies that touched them, from which the change may have taken the support; a change of gravity wakes
// all. O(pairs that are near each other + bodies).
void forget_contacts(World& world, const Delta& delta);
// Forgets the contacts of these bodies, which may be in any order.
void forget_contacts(World& world, std::vector<BodyId> bodies);

// Forgets of all pairs all but which bodies they are, and whether they touch or intersect: what a journal
// says of them (see BodyStates). Bodies go on as well, but not to the bit as they would have, so that it has
// to happen where replay does it, too.
void forget_details(World& world);

}  // namespace kerf
