#pragma once

#include "core/world/world.h"

namespace kerf {

// Estimates which of two fronts of the open search of a body will turn out to be the larger part: faces that
// are sampled over the component belong to the front that has reached them, or else to the one whose frontier
// is nearer in the mean. Preconditions: both fronts grow in one component, and both have a frontier. Reads a
// few hundred faces. Private to core/edit.
uint32_t likely_larger(const Body& body, uint32_t a, uint32_t b);

}  // namespace kerf
