#include "core/game/arena/obstacles.h"

#include <algorithm>

#include "core/game/arena/fixed_faces.h"
#include "core/mesh/point_to_triangle.h"

namespace kerf {

Obstacles::Obstacles(const Arena& arena) : half_(0.5 * arena.description.size) {
  columns_ = column(half_.x) + 1;
  rows_ = row(half_.y) + 1;
  in_cell_.resize(static_cast<size_t>(columns_ * rows_));
  for (const Triangle& t : fixed_faces(arena)) {
    if (is_drivable(t)) continue;
    const Vec3 low = glm::min(glm::min(t[0], t[1]), t[2]), high = glm::max(glm::max(t[0], t[1]), t[2]);
    if (high.x < -half_.x || low.x > half_.x || high.z < -half_.y || low.z > half_.y) continue;
    const auto index = static_cast<uint32_t>(faces_.size());
    faces_.push_back(t);
    const Cells cells = cells_between(low, high);
    for (int z = cells.low; z <= cells.high; ++z) {
      for (int x = cells.left; x <= cells.right; ++x)
        in_cell_[static_cast<size_t>(z * columns_ + x)].push_back(index);
    }
  }
}

Obstacles::Cells Obstacles::cells_between(const Vec3& low, const Vec3& high) const {
  const auto within = [](double at, double half) { return std::clamp(at, -half, half); };
  return {column(within(low.x, half_.x)), column(within(high.x, half_.x)), row(within(low.z, half_.y)),
          row(within(high.z, half_.y))};
}

std::optional<Obstacles::Touch> Obstacles::touched_by(const Vec3& centre, double radius) const {
  std::optional<Touch> deepest;
  if (faces_.empty()) return deepest;
  const Cells cells = cells_between(centre - Vec3(radius), centre + Vec3(radius));
  for (int z = cells.low; z <= cells.high; ++z) {
    for (int x = cells.left; x <= cells.right; ++x) {
      for (const uint32_t face : in_cell_[static_cast<size_t>(z * columns_ + x)]) {
        const Vec3 at = nearest_point(centre, faces_[face]), way = centre - at;
        const double distance = glm::length(way);
        if (distance >= (deepest ? deepest->distance : radius) || !(distance > 0)) continue;
        if (way.y <= kDrivable * distance) deepest = Touch{at, distance};
      }
    }
  }
  return deepest;
}

}  // namespace kerf
