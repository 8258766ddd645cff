#include "core/mesh/point_to_triangle.h"

#include <algorithm>
#include <glm/geometric.hpp>
#include <limits>

namespace kerf {

namespace {

double distance2_to_segment(const Vec3& p, const Vec3& a, const Vec3& b) {
  const Vec3 apart = p - nearest_on_segment(p, a, b);
  return glm::dot(apart, apart);
}

}  // namespace

Vec3 nearest_on_segment(const Vec3& p, const Vec3& a, const Vec3& b) {
  const Vec3 along = b - a;
  const double length2 = glm::dot(along, along);
  const double t = length2 > 0 ? std::clamp(glm::dot(p - a, along) / length2, 0.0, 1.0) : 0;
  return a + t * along;
}

double squared_distance(const Vec3& p, const Triangle& t) {
  double nearest = std::numeric_limits<double>::infinity();
  for (int i = 0; i < 3; ++i) nearest = std::min(nearest, distance2_to_segment(p, t[i], t[(i + 1) % 3]));
  const Vec3 normal = glm::cross(t[1] - t[0], t[2] - t[0]);
  const double length2 = glm::dot(normal, normal);
  if (!(length2 > 0)) return nearest;
  for (int i = 0; i < 3; ++i) {
    if (glm::dot(glm::cross(t[(i + 1) % 3] - t[i], p - t[i]), normal) < 0) return nearest;
  }
  const double height = glm::dot(p - t[0], normal);
  return std::min(nearest, height * height / length2);
}

Vec3 nearest_point(const Vec3& p, const Triangle& t) {
  Vec3 nearest = t[0];
  double least = std::numeric_limits<double>::infinity();
  const auto try_point = [&](const Vec3& q) {
    const double distance2 = glm::dot(p - q, p - q);
    if (distance2 >= least) return;
    least = distance2;
    nearest = q;
  };
  for (int i = 0; i < 3; ++i) try_point(nearest_on_segment(p, t[i], t[(i + 1) % 3]));
  const Vec3 normal = glm::cross(t[1] - t[0], t[2] - t[0]);
  const double length2 = glm::dot(normal, normal);
  if (!(length2 > 0)) return nearest;
  for (int i = 0; i < 3; ++i) {
    if (glm::dot(glm::cross(t[(i + 1) % 3] - t[i], p - t[i]), normal) < 0) return nearest;
  }
  try_point(p - (glm::dot(p - t[0], normal) / length2) * normal);
  return nearest;
}

}  // namespace kerf
