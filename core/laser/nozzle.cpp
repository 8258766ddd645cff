#include "core/laser/nozzle.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "core/base/assert.h"
#include "core/base/deterministic_math.h"
#include "core/laser/laser.h"

namespace kerf {

namespace {

// Keeps the part of a polygon where the distance is not positive.
template <typename Distance>
void clip(std::vector<Vec3>& polygon, Distance distance) {
  std::vector<Vec3> kept;
  for (size_t i = 0; i < polygon.size(); ++i) {
    const Vec3 &p = polygon[i], &q = polygon[(i + 1) % polygon.size()];
    const double at_p = distance(p), at_q = distance(q);
    if (at_p <= 0) kept.push_back(p);
    if ((at_p < 0 && at_q > 0) || (at_p > 0 && at_q < 0)) kept.push_back(p + at_p / (at_p - at_q) * (q - p));
  }
  polygon = std::move(kept);
}

// `t` has its third coordinate along the axis, from the tip.
bool meets(const Triangle& t, const Nozzle& nozzle) {
  std::vector<Vec3> polygon(t.begin(), t.end());
  clip(polygon, [](const Vec3& p) { return -p.z; });
  clip(polygon, [&](const Vec3& p) { return p.z - nozzle.length; });
  for (int k = 0; k < Nozzle::kSides && !polygon.empty(); ++k) {
    const SinCos side = sin_cos(2 * kPi * k / Nozzle::kSides);
    clip(polygon,
         [&](const Vec3& p) { return side.cos * p.x + side.sin * p.y - nozzle.radius - nozzle.slope * p.z; });
  }
  return !polygon.empty();
}

}  // namespace

bool collides(const Mesh& mesh, const AabbTree& tree, const Pose& beam, const Nozzle& nozzle) {
  KERF_ASSERT(nozzle.radius > 0 && nozzle.slope >= 0 && nozzle.length > 0);
  const Vec3 axis = -beam.direction, right = across(axis), up = glm::cross(axis, right);
  const double half = 0.5 * nozzle.length, widest = nozzle.radius + nozzle.slope * nozzle.length;
  constexpr double kCorner = 1.01;  // exceeds the ratio of a pyramid's corners to the cone
  std::vector<PointOnFace> near;
  tree.points_within(mesh, beam.origin + half * axis,
                     std::sqrt(half * half + kCorner * kCorner * widest * widest), near);
  return std::ranges::any_of(near, [&](const PointOnFace& point) {
    Triangle t = mesh.triangle(point.face);
    for (Vec3& p : t) {
      const Vec3 from = p - beam.origin;
      p = {glm::dot(from, right), glm::dot(from, up), glm::dot(from, axis)};
    }
    return meets(t, nozzle);
  });
}

}  // namespace kerf
