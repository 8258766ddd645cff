#pragma once

#include <vector>

#include "core/base/vec3.h"

namespace kerf {

// For each point of a polygonal line, the squared error (m^2) from which on a simplified line goes without
// it: infinite for the ends, 0 for points that are left out at `least_error` (m) already. The line of all
// points with larger values than the square of an error is the one that keeps, beside the ends, of each part
// between kept points the one farthest from the segment between them, as long as it is farther than the error
// (D. Douglas, T. Peucker: Algorithms for the reduction of the number of points required to represent a
// digitized line, 1973). A closed line, whose first and last points are equal, always keeps the point
// farthest from them. O(n^2) at worst, O(n log n) as a rule.
std::vector<double> left_out_from(const std::vector<Vec3>& line, double least_error);

// The simplified line for an error (m).
std::vector<Vec3> simplified(const std::vector<Vec3>& line, double error);

}  // namespace kerf
