#pragma once

#include "core/base/tolerances.h"
#include "core/base/vec3.h"

namespace kerf {

// Whether a squared length read from a file is that of a unit vector or quaternion; see kUnitSlack.
constexpr bool is_unit_length2(double length2, double slack = kUnitSlack) {
  return length2 - 1 < slack && 1 - length2 < slack;
}

// Whether a vector is a unit vector, as a precondition. The slack is larger than that of files, because a
// direction may have been rotated by an orientation that has an error of its own.
inline bool is_unit(const Vec3& v) { return is_unit_length2(glm::dot(v, v), 16 * kUnitSlack); }

// Whether two unit vectors are opposite to each other up to rounding, so that no direction lies between them;
// see kOpposite. Precondition: both are unit vectors.
inline bool are_opposite(const Vec3& a, const Vec3& b) {
  const Vec3 sum = a + b;
  return glm::dot(sum, sum) < kOpposite * kOpposite;
}

}  // namespace kerf
