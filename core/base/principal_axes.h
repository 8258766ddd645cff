#pragma once

#include <array>
#include <span>

#include "core/base/geometry.h"

namespace kerf {

// Returns the mean of points; zero without points. O(n).
Vec3 mean_of(std::span<const Vec3> points);

// Returns the unit directions in which points extend most around `mean`, by descending extent, each with a
// positive largest component (principal components: K. Pearson: On lines and planes of closest fit to systems
// of points in space, 1901). Orthogonal, but perhaps left-handed. O(n).
std::array<Vec3, 3> principal_axes(std::span<const Vec3> points, const Vec3& mean);

}  // namespace kerf
