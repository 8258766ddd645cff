#pragma once

#include "core/physics/contact/contact.h"
#include "core/physics/contact/moving_body.h"
#include "core/world/surroundings.h"

namespace kerf {

// Finds the contacts of two bodies, at most 8: the deepest and then those that lie farthest apart. Brings
// `memory` up to date and takes the impulses of the last tick from it.
//
// Sheets that intersect when they meet do not touch until they are apart; they are pushed out of each other
// (see push_out).
std::vector<Contact> find_contacts(const MovingBody& first, const MovingBody& second,
                                   const ContactLengths& lengths, PairMemory& memory);

// The contacts of the points of a body with the ground, with the impulses that `memory` holds.
std::vector<Contact> find_ground_contacts(const MovingBody& body, const Surroundings& around,
                                          const ContactLengths& lengths, const PairMemory& memory);

// Keeps the impulses of contacts for the next tick. Forgets the points at rims that were not pressed.
void remember_impulses(const std::vector<Contact>& contacts, PairMemory& memory);

}  // namespace kerf
