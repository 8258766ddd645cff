#pragma once

#include <optional>

#include "core/base/assert.h"
#include "core/base/pose.h"
#include "core/base/unit_vector.h"

namespace kerf {

// How far along a line through `at` (a unit vector `axis` points along it) the point of the line is that is
// nearest to a ray. Nothing where the line is seen nearly from its end and so cannot be followed.
inline std::optional<double> along_axis(const Pose& ray, const Vec3& at, const Vec3& axis) {
  KERF_ASSERT(is_unit(axis));
  constexpr double kLeastSine2 = 1e-3;  // the square of the sine of the angle between the two
  const double cosine = glm::dot(axis, ray.direction), sine2 = 1 - cosine * cosine;
  if (sine2 < kLeastSine2) return std::nullopt;
  const Vec3 from = ray.origin - at;
  return (glm::dot(from, axis) - cosine * glm::dot(from, ray.direction)) / sine2;
}

}  // namespace kerf
