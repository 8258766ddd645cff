#pragma once

#include <span>

#include "core/physics/contact_search.h"

namespace kerf {

// Shortens the ways of bodies in a tick, after the solver has moved them, until no two sheets intersect that
// did not do so at its beginning. The motion of a body that was held back is slowed.
//
// Each body goes a share of its way: all of it, a half, a quarter, or none. The shares of two bodies that
// would intersect are lowered until they do not; where nobody moves nothing new intersects, so this ends.
// Bodies that are too light to stop another one (see Guided) may intersect it, and so may those that must
// come out of the ground. On several threads; the result does not depend on how many there are. Precondition:
// MovingBody::next is where the bodies have gone. Returns how many bodies were held back.
size_t hold_back(std::span<MovingBody> bodies, ContactSearch& search);

}  // namespace kerf
