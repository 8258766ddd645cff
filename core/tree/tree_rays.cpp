#include "core/tree/tree_rays.h"

#include <algorithm>
#include <cmath>

#include "core/base/tolerances.h"
#include "core/tree/sheared_ray.h"

namespace kerf {

namespace {

// Roundings of a float, of which a walk adds up a dozen: sixteen halves of its last place.
constexpr double kManyRoundings = 0x1p-20;
// What two roundings may take off a number or add to it.
constexpr double kTwoRoundings = 0x1p-21;
constexpr double kLeastComponent = 1e-20;

// The slabs of one axis: `low` and `high` bound where the rays stand at t = 0, `error` included.
void set_slabs(RayQuery& q, int k, double direction, double low, double high) {
  const bool up = direction >= 0;
  const double d = std::max(std::abs(direction), kLeastComponent) * (up ? 1 : -1);
  q.near_plane[k] = static_cast<uint32_t>(up ? k : k + 3);
  q.far_plane[k] = static_cast<uint32_t>(up ? k + 3 : k);
  q.near_origin[k] = static_cast<float>(up ? high : low);
  q.far_origin[k] = static_cast<float>(up ? low : high);
  q.near_slope[k] = static_cast<float>((1 - kTwoRoundings) / d);
  q.far_slope[k] = static_cast<float>((1 + kTwoRoundings) / d);
}

}  // namespace

float TreeRays::t_beyond(double length) const {
  return static_cast<float>(std::min<double>(query.t_high, t_at_origin + length * t_per_length));
}

std::optional<TreeRays> prepare_rays(const TreeStore& tree, std::span<const Pose> rays, Interval range) {
  const Vec3 d = rays[0].direction;
  const double reach = tree.reach(), scale = tree.frame.scale, back = 2 * reach;
  Vec3 low{1e300}, high{-1e300};
  double slack = 0, first = 1e300, last = -1e300, nearest = 1e300;
  TreeRays r{};
  const ShearedRay sheared(rays[0]);
  const int along = sheared.along();
  // t = 0 lies across the rays, before all boxes.
  for (size_t i = 0; i < rays.size(); ++i) {
    const Vec3 start = (rays[i].origin - tree.frame.origin) * scale;
    const double to_middle = -glm::dot(start, d) / glm::dot(d, d);
    const Vec3 middle = start + to_middle * d;
    for (int k = 0; k < 2; ++k) {
      r.query.pass[i][k] = static_cast<float>(middle[sheared.across(k)] - sheared.shear()[k] * middle[along]);
    }
    low = glm::min(low, middle);
    high = glm::max(high, middle);
    const double own_slack =
        kBoxSlack * (8 * reach + std::abs(start.x) + std::abs(start.y) + std::abs(start.z));
    slack = std::max(slack, own_slack);
    first = std::min(first, range.low * scale - to_middle + back);
    last = std::max(last, range.high * scale - to_middle + back);
    nearest = std::min(nearest, glm::dot(middle, middle));
    if (i == 0) r.t_at_origin = back - to_middle;
  }
  const double error = reach * kManyRoundings + slack;
  if (nearest > (reach + error) * (reach + error)) return std::nullopt;
  for (int k = 0; k < 3; ++k)
    set_slabs(r.query, k, d[k], low[k] - back * d[k] - error, high[k] - back * d[k] + error);
  r.query.t_low = static_cast<float>(std::max(first - 2 * error, 1e-30 * reach));
  r.query.t_high = static_cast<float>(std::min(last + 2 * error, 4 * reach));
  if (!(r.query.t_low <= r.query.t_high)) return std::nullopt;
  r.query.along = static_cast<uint32_t>(along);
  for (int k = 0; k < 2; ++k) {
    r.query.across[k] = static_cast<uint32_t>(sheared.across(k));
    r.query.shear[k] = static_cast<float>(sheared.shear()[k]);
  }
  r.query.error = static_cast<float>(2 * error);
  r.query.rays = static_cast<uint32_t>(rays.size());
  r.t_at_origin += 2 * error;
  r.t_per_length = scale;
  return r;
}

}  // namespace kerf
