#pragma once

#include <vector>

#include "core/base/vec3.h"

namespace kerf {

// A part of the points of a polygonal line, its ends among them, such that no point left out is farther than
// `error` (m) from the line through those kept (D. Douglas, T. Peucker: Algorithms for the reduction of the
// number of points required to represent a digitized line, 1973). A closed line, whose first and last points
// are equal, keeps the point farthest from them. O(n^2) at worst, O(n log n) as a rule.
std::vector<Vec3> simplified(const std::vector<Vec3>& line, double error);

}  // namespace kerf
