#pragma once

#include "core/physics/contact/contact.h"
#include "core/physics/contact/rigid_body.h"
#include "core/world/rigid_body.h"

namespace kerf {

// Finds edge-edge contacts of the chords of two bodies. Appends to `out`, with normals towards `first` and
// features >= 2^32.
//
// Two chords touch if the closest points of their lines lie within both. Since no sheets intersect at the
// beginning of a tick (see limit_penetration), the side on which they are then is the right one. Nearly
// parallel chords are covered by points and faces.
void find_chord_contacts(const MovingBody& first, const MovingBody& second, const ContactLengths& lengths,
                         std::vector<Contact>& out);

// Finds the contacts of two bodies, at most 8: the deepest and then those farthest apart. Updates `memory`
// and applies the impulses of the last tick from it.
//
// Sheets that intersect when they meet touch only after they were apart; push_out() separates them.
std::vector<Contact> find_contacts(const MovingBody& first, const MovingBody& second,
                                   const ContactLengths& lengths, PairMemory& memory);

// Returns the contacts of the points of a body with the ground, with the impulses in `memory`.
std::vector<Contact> find_ground_contacts(const MovingBody& body, const Environment& around,
                                          const ContactLengths& lengths, const PairMemory& memory);

// Returns the depth of the lowest corner of a body below the ground at `map` (body to world), in units of
// length; 0 if it is above. O(corners) near the ground.
double depth_below_ground(const MovingBody& body, const RigidMap& map, const Environment& around);

}  // namespace kerf
