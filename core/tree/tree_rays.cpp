#include "core/tree/tree_rays.h"

#include <smmintrin.h>

#include <algorithm>
#include <cmath>

#include "core/base/tolerances.h"

namespace kerf {

namespace {

// Roundings of a float, of which a walk adds up a dozen: sixteen halves of its last place.
constexpr double kManyRoundings = 0x1p-20;
// What a few roundings may take off a number or add to it.
constexpr float kFewRoundings = 0x1p-20f;
constexpr float kLeastComponent = 1e-20f;

__m128 to_floats(const Vec3& v) {
  return _mm_movelh_ps(_mm_cvtpd_ps(_mm_setr_pd(v.x, v.y)), _mm_cvtpd_ps(_mm_set_sd(v.z)));
}

// The slabs, for rays that stand between `low` and `high` at t = 0. All axes at a time.
void set_slabs(RayQuery& q, const Vec3& direction, const Vec3& low, const Vec3& high) {
  const __m128 d = to_floats(direction), sign = _mm_set1_ps(-0.0f), down = _mm_and_ps(d, sign);
  const __m128 size = _mm_max_ps(_mm_andnot_ps(sign, d), _mm_set1_ps(kLeastComponent));
  const __m128 slope = _mm_or_ps(_mm_div_ps(_mm_set1_ps(1), size), down);
  const __m128 a = to_floats(low), b = to_floats(high);
  _mm_store_ps(q.near_origin, _mm_blendv_ps(b, a, down));
  _mm_store_ps(q.far_origin, _mm_blendv_ps(a, b, down));
  _mm_store_ps(q.near_slope, _mm_mul_ps(slope, _mm_set1_ps(1 - kFewRoundings)));
  _mm_store_ps(q.far_slope, _mm_mul_ps(slope, _mm_set1_ps(1 + kFewRoundings)));
  const auto bits = static_cast<uint32_t>(_mm_movemask_ps(down));
  for (uint32_t k = 0; k < 3; ++k) {
    const uint32_t turned = 3 * (bits >> k & 1);
    q.near_plane[k] = k + turned;
    q.far_plane[k] = k + 3 - turned;
  }
}

// Where a ray passes the origin of the tree's frame.
struct Passing {
  Vec3 point;
  double at;   // along the ray
  double far;  // how large the numbers are that this comes from
};
Passing passing(const TreeStore& tree, const Pose& ray) {
  const Vec3 start = tree.frame.to_tree(ray.origin);
  const double at = -glm::dot(start, ray.direction);
  return {start + at * ray.direction, at, std::abs(start.x) + std::abs(start.y) + std::abs(start.z)};
}

}  // namespace

bool prepare_rays(const TreeStore& tree, std::span<const Pose> rays, const ShearedRay& sheared,
                  Interval range, RayQuery& q) {
  const Vec3 d = rays[0].direction;
  const auto set_pass = [&](size_t i, const Vec3& p) {
    for (int k = 0; k < 2; ++k)
      q.pass[i][k] = static_cast<float>(p[sheared.across(k)] - sheared.shear()[k] * p[sheared.along()]);
  };
  const Passing own = passing(tree, rays[0]);
  set_pass(0, own.point);
  Vec3 low = own.point, high = own.point;
  double far = own.far, earliest = own.at, latest = own.at, nearest = glm::dot(own.point, own.point);
  for (size_t i = 1; i < rays.size(); ++i) {
    const Passing other = passing(tree, rays[i]);
    set_pass(i, other.point);
    low = glm::min(low, other.point);
    high = glm::max(high, other.point);
    far = std::max(far, other.far);
    earliest = std::min(earliest, other.at);
    latest = std::max(latest, other.at);
    nearest = std::min(nearest, glm::dot(other.point, other.point));
  }
  const double reach = tree.reach(), scale = tree.frame.scale, back = 2 * reach;
  const double error = reach * kManyRoundings + kBoxSlack * (8 * reach + far);
  if (nearest > (reach + error) * (reach + error)) return false;
  // t = 0 lies across the rays, before all boxes.
  set_slabs(q, d, low - back * d - error, high - back * d + error);
  q.t_low = static_cast<float>(std::max(back - latest + range.low * scale - 2 * error, 1e-30 * reach));
  q.t_high = static_cast<float>(std::min(back - earliest + range.high * scale + 2 * error, 4 * reach));
  q.t_sure = static_cast<float>(back - own.at + range.low * scale + 4 * error);
  q.along = static_cast<uint32_t>(sheared.along());
  for (int k = 0; k < 2; ++k) {
    q.across[k] = static_cast<uint32_t>(sheared.across(k));
    q.shear[k] = static_cast<float>(sheared.shear()[k]);
  }
  q.error = static_cast<float>(2 * error);
  q.rays = static_cast<uint32_t>(rays.size());
  return q.t_low <= q.t_high;
}

}  // namespace kerf
