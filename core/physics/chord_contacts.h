#pragma once

#include "core/physics/contact.h"
#include "core/physics/moving_body.h"
#include "core/world/contact_memory.h"

namespace kerf {

// Finds where chords of two bodies touch, edge against edge, and brings the sides on which they are up to
// date.
//
// Two chords touch where the shortest way between their lines lies within both. The side of it is remembered
// as long as it does, and a chord that takes the place of its neighbour inherits it, so that an edge that was
// pushed through another is pushed back. Chords that are nearly parallel are left to points and faces.
// Appends to `out`, with normals towards `first` and features of 2^32 and more.
void find_chord_contacts(const MovingBody& first, const MovingBody& second, const ContactLengths& lengths,
                         std::vector<ChordMemory>& memory, std::vector<Contact>& out);

}  // namespace kerf
