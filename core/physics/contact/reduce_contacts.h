#pragma once

#include <vector>

#include "core/physics/contact/contact.h"

namespace kerf {

inline constexpr size_t kMostContacts = 8;  // of a pair of bodies, or of a body with the ground

// Leaves at most kMostContacts: the deepest and those that lie farthest apart, in their order.
void reduce_contacts(std::vector<Contact>& contacts);

// The same for contacts with one plane, of which `up` is the unit normal: the deepest around places on it
// that lie farthest apart, measured along the longest way between contacts and across it in units of how far
// they reach. So a body that rests on many points rests on the lowest ones, and a needle on both its sides. A
// contact that carried in the last tick counts as deeper by `bonus` (in units of length), so that the choice
// does not jump between points that are about as deep.
void reduce_on_plane(std::vector<Contact>& contacts, const Vec3& up, double bonus);

}  // namespace kerf
