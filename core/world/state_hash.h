#pragma once

#include <cstdint>

#include "core/world/world.h"

namespace kerf {

// A number for the state of the world, equal for equal states on every machine: a sum over the live faces of
// a mix of the bits of their corners (least corner first), level, body and energy, where they have any, and
// of the placements. It does not depend on slots or on the order of edits. The clock is part of it once time
// has passed, and the motion of a body once it has moved. O(faces).
uint64_t state_hash(const World& world);

}  // namespace kerf
