#pragma once

#include <vector>

#include "core/base/vec3.h"

namespace kerf {

// Adds indices of points that lie as far apart as possible to `chosen`: each is the point farthest from all
// that were chosen before (T. Gonzalez, 1985), of equal ones the first, until `chosen` has `most` members or
// no point lies apart from those chosen. O(points * most).
void choose_spread(const std::vector<Vec3>& points, size_t most, std::vector<uint32_t>& chosen);

// Adds the indices of the points that are extreme along the axes and the diagonals of space, each once.
void choose_extreme(const std::vector<Vec3>& points, std::vector<uint32_t>& chosen);

}  // namespace kerf
