#pragma once

#include "core/world/delta.h"
#include "core/world/world.h"

namespace kerf {

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
