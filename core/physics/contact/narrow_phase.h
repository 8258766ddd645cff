#pragma once

#include "core/physics/contact/contact.h"
#include "core/physics/contact/rigid_body.h"
#include "core/world/rigid_body.h"

namespace kerf {

// Finds where chords of two bodies touch, edge against edge. Appends to `out`, with normals towards `first`
// and features of 2^32 and more.
//
// Two chords touch where the shortest way between their lines lies within both. Since no sheets intersect at
// the beginning of a tick (see hold_back), the side on which they are then is the right one. Chords that are
// nearly parallel are left to points and faces.
void find_chord_contacts(const MovingBody& first, const MovingBody& second, const ContactLengths& lengths,
                         std::vector<Contact>& out);

// Finds the contacts of two bodies, at most 8: the deepest and then those that lie farthest apart. Brings
// `memory` up to date and takes the impulses of the last tick from it.
//
// Sheets that intersect when they meet do not touch until they are apart; they are pushed out of each other
// (see push_out).
std::vector<Contact> find_contacts(const MovingBody& first, const MovingBody& second,
                                   const ContactLengths& lengths, PairMemory& memory);

// The contacts of the points of a body with the ground, with the impulses that `memory` holds.
std::vector<Contact> find_ground_contacts(const MovingBody& body, const Environment& around,
                                          const ContactLengths& lengths, const PairMemory& memory);

// How far a body is below the ground at `map` (body to world), with the lowest of its corners; 0 where it is
// not. In units of length. O(corners) near the ground.
double depth_below_ground(const MovingBody& body, const RigidMap& map, const Environment& around);

}  // namespace kerf
