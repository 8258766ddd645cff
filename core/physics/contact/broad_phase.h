#pragma once

#include <span>
#include <utility>
#include <vector>

#include "core/physics/contact/moving_body.h"

namespace kerf {

// The pairs of bodies, by their indices, of which at least one moves and whose bounds overlap on their ways:
// in the world, and in the frames of both. Sorted. Bodies that glide do not touch fixed ones. By sorting
// along the axis of the largest extent and sweeping (D. Baraff: Dynamic simulation of non-penetrating rigid
// bodies, 1992). O(n log n + overlaps along that axis).
std::vector<std::pair<uint32_t, uint32_t>> near_pairs(std::span<const MovingBody> bodies);

}  // namespace kerf
