#pragma once

#include <vector>

#include "core/physics/contact/contact.h"

namespace kerf {

// Added to the features of contacts that points of the second body of a pair found.
inline constexpr uint64_t kOnSecond = uint64_t{1} << 31;

// Gives contacts the impulses that they had in the last tick, by their features.
void take_impulses(const PairMemory& memory, std::vector<Contact>& contacts);

// Keeps the impulses of contacts for the next tick. Forgets the points at rims that were not pressed.
void remember_impulses(const std::vector<Contact>& contacts, PairMemory& memory);

}  // namespace kerf
