#pragma once

#include "core/physics/contact/contact.h"
#include "core/physics/contact/moving_body.h"

namespace kerf {

// Finds where chords of two bodies touch, edge against edge. Appends to `out`, with normals towards `first`
// and features of 2^32 and more.
//
// Two chords touch where the shortest way between their lines lies within both. Since no sheets intersect at
// the beginning of a tick (see hold_back), the side on which they are then is the right one. Chords that are
// nearly parallel are left to points and faces.
void find_chord_contacts(const MovingBody& first, const MovingBody& second, const ContactLengths& lengths,
                         std::vector<Contact>& out);

}  // namespace kerf
