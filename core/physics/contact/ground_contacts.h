#pragma once

#include "core/physics/contact/contact.h"
#include "core/physics/contact/moving_body.h"
#include "core/world/environment.h"

namespace kerf {

// The contacts of the points of a body with the ground, with the impulses that `memory` holds.
std::vector<Contact> find_ground_contacts(const MovingBody& body, const Environment& around,
                                          const ContactLengths& lengths, const PairMemory& memory);

// How far a body is below the ground at `map` (body to world), with the lowest of its corners; 0 where it is
// not. In units of length. O(corners) near the ground.
double depth_below_ground(const MovingBody& body, const RigidMap& map, const Environment& around);

}  // namespace kerf
