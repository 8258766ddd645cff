#pragma once

#include "core/physics/contact/contact.h"
#include "core/physics/contact/moving_body.h"

namespace kerf {

// Finds the contacts of two bodies, at most 8: the deepest and then those that lie farthest apart. Brings
// `memory` up to date and takes the impulses of the last tick from it.
//
// Sheets that intersect when they meet do not touch until they are apart; they are pushed out of each other
// (see push_out).
std::vector<Contact> find_contacts(const MovingBody& first, const MovingBody& second,
                                   const ContactLengths& lengths, PairMemory& memory);

}  // namespace kerf
