#include "core/tree/tree_internal.h"

#include <smmintrin.h>
#include <algorithm>
#include <bit>
#include <cassert>
#include <cmath>
#include <cstdint>

#include "core/base/assert.h"
#include "core/base/geometry.h"
#include "core/base/tolerances.h"
#include "core/tree/aabb_tree.h"
#include "core/tree/walks.h"

namespace kerf {

namespace {

__extension__ using Wide = unsigned __int128;

// A finite double, decomposed: sign * mantissa * 2^exponent with a mantissa of 53 bits, or zero.
struct Parts {
  int sign;
  int exponent;
  uint64_t mantissa;

  explicit Parts(double x) {
    assert(std::isfinite(x));
    const auto bits = std::bit_cast<uint64_t>(x);
    const int field = static_cast<int>(bits >> 52 & 0x7ff);
    mantissa = (bits & 0xfffffffffffffu) | (field != 0 ? uint64_t{1} << 52 : 0);
    exponent = field != 0 ? field : 1;
    sign = mantissa == 0 ? 0 : (x < 0 ? -1 : 1);
    if (mantissa == 0) return;
    const int shift = std::countl_zero(mantissa) - 11;
    mantissa <<= shift;
    exponent -= shift;
  }
};

// The exact product of two doubles, with a mantissa of 106 bits.
struct Product {
  int sign;
  int exponent;
  Wide mantissa;

  Product(double a, double b) {
    const Parts p(a), q(b);
    sign = p.sign * q.sign;
    exponent = p.exponent + q.exponent;
    mantissa = Wide{p.mantissa} * q.mantissa;
    if (sign != 0 && (mantissa >> 105) == 0) {
      mantissa <<= 1;
      --exponent;
    }
  }
};

int compare(const Product& a, const Product& b) {
  if (a.sign != b.sign) return a.sign > b.sign ? 1 : -1;
  if (a.sign == 0) return 0;
  if (a.exponent != b.exponent) return (a.exponent > b.exponent) == (a.sign > 0) ? 1 : -1;
  if (a.mantissa != b.mantissa) return (a.mantissa > b.mantissa) == (a.sign > 0) ? 1 : -1;
  return 0;
}

// Rounding is monotonic: products that differ after rounding have the same order before it.
inline int sign_of_cross(Vec2 a, Vec2 b) {
  const double left = a.x * b.y, right = a.y * b.x;
  if (left != right) return left > right ? 1 : -1;
  return compare(Product(a.x, b.y), Product(a.y, b.x));
}

// Returns true if the ray passes to the left of a -> b. Ties are broken as if the ray were displaced by an
// infinitesimal amount towards +x and a smaller one towards +y.
inline bool is_left(Vec2 a, Vec2 b) {
  const double left = a.x * b.y, right = a.y * b.x;
  if (left != right) return left > right;
  const int side = sign_of_cross(a, b);
  if (side != 0) return side > 0;
  return a.y != b.y ? a.y > b.y : a.x < b.x;
}

// Returns a sum that does not depend on the order of its arguments.
double sum_in_order(double a, double b, double c) {
  const double low = std::min(a, b), high = std::max(a, b);
  return (std::min(low, c) + std::max(high, c)) + std::max(low, std::min(high, c));
}

}  // namespace

int side_of(Vec2 a, Vec2 b) { return sign_of_cross(a, b); }

ShearedRay::ShearedRay(const Pose& ray) : origin_(ray.origin) {
  assert(is_unit(ray.direction));
  const Vec3 d = ray.direction, size = glm::abs(d);
  z_ = longest_axis(size.x, size.y, size.z);
  x_ = kNextAxis[z_];
  y_ = kNextAxis[x_];
  shear_ = {d[x_] / d[z_], d[y_] / d[z_]};
  per_z_ = 1.0 / d[z_];
}

std::optional<double> ShearedRay::cross(const Triangle& t) const {
  Vec2 p[3];
  double z[3];
  for (int i = 0; i < 3; ++i) {
    z[i] = t[i][z_] - origin_[z_];
    p[i] = {(t[i][x_] - origin_[x_]) - shear_.x * z[i], (t[i][y_] - origin_[y_]) - shear_.y * z[i]};
  }
  const int left = is_left(p[0], p[1]) + is_left(p[1], p[2]) + is_left(p[2], p[0]);
  if (left % 3 != 0) return std::nullopt;
  const double a = cross2(p[1], p[2]), b = cross2(p[2], p[0]), c = cross2(p[0], p[1]);
  const double sum = sum_in_order(a, b, c);
  // A triangle projected to a point is parallel to the ray. One whose projected area rounds to 0 is crossed.
  if (p[0] == p[1] && p[1] == p[2]) return std::nullopt;
  if (sum == 0) return sum_in_order(z[0], z[1], z[2]) / 3 * per_z_;
  return sum_in_order(a * z[0], b * z[1], c * z[2]) / sum * per_z_;
}

namespace {

static_assert(RayQuery::kPositionShift == Positions::kShift && sizeof(Vec3) == 24);

void store(uint32_t (&out)[4], __m128 bits) {
  _mm_store_si128(reinterpret_cast<__m128i*>(out), _mm_castps_si128(bits));
}
__m128 to_floats(const Vec3& v) {
  return _mm_movelh_ps(_mm_cvtpd_ps(_mm_setr_pd(v.x, v.y)), _mm_cvtpd_ps(_mm_set_sd(v.z)));
}
__m128 size_of(__m128 v) { return _mm_andnot_ps(_mm_set1_ps(-0.0f), v); }

// Prepares the slab test for rays of direction d that start between `low` and `high` at t = 0, by axis.
void set_slabs(RayQuery& q, __m128 d, __m128 low, __m128 high) {
  const __m128 sign = _mm_set1_ps(-0.0f), down = _mm_and_ps(d, sign);
  const __m128 size = _mm_max_ps(size_of(d), _mm_set1_ps(kMinComponent));
  const __m128 slope = _mm_or_ps(_mm_div_ps(_mm_set1_ps(1), size), down);
  _mm_store_ps(q.near_origin, _mm_blendv_ps(high, low, down));
  _mm_store_ps(q.far_origin, _mm_blendv_ps(low, high, down));
  _mm_store_ps(q.near_slope, _mm_mul_ps(slope, _mm_set1_ps(1 - kSlopeRoundings)));
  _mm_store_ps(q.far_slope, _mm_mul_ps(slope, _mm_set1_ps(1 + kSlopeRoundings)));
  const __m128 lows = _mm_castsi128_ps(_mm_setr_epi32(0, 1, 2, 3)),
               highs = _mm_castsi128_ps(_mm_setr_epi32(3, 4, 5, 6));
  store(q.near_plane, _mm_blendv_ps(lows, highs, down));
  store(q.far_plane, _mm_blendv_ps(highs, lows, down));
}

bool may_meet(const RayQuery& q, const FloatBox& box) {
  const __m128 down = _mm_load_ps(q.direction);  // blends by sign
  const __m128 near = _mm_blendv_ps(box.low, box.high, down), far = _mm_blendv_ps(box.high, box.low, down);
  const __m128 entry = _mm_mul_ps(_mm_sub_ps(near, _mm_load_ps(q.near_origin)), _mm_load_ps(q.near_slope));
  const __m128 exit = _mm_mul_ps(_mm_sub_ps(far, _mm_load_ps(q.far_origin)), _mm_load_ps(q.far_slope));
  // Compares every entry with every exit, including the limits of the range.
  const __m128 from = _mm_insert_ps(entry, _mm_set_ss(q.t_low), 3 << 4),
               to = _mm_insert_ps(exit, _mm_set_ss(q.t_high), 3 << 4);
  const __m128 to2 = _mm_min_ps(to, _mm_shuffle_ps(to, to, _MM_SHUFFLE(2, 3, 0, 1)));
  const __m128 to4 = _mm_min_ps(to2, _mm_shuffle_ps(to2, to2, _MM_SHUFFLE(1, 0, 3, 2)));
  return _mm_movemask_ps(_mm_cmple_ps(from, to4)) == 15;
}

// The point of a ray nearest to the origin of the tree's frame.
struct Passing {
  Passing(const TreeFrame& frame, const Pose& ray) {
    const Vec3 start = frame.to_tree(ray.origin);
    at = -glm::dot(start, ray.direction);
    point = to_floats(start + at * ray.direction);
    far = std::abs(start.x) + std::abs(start.y) + std::abs(start.z);
  }
  double distance2() const { return _mm_cvtss_f32(_mm_dp_ps(point, point, 0x71)); }

  __m128 point;
  double at;   // parameter along the ray
  double far;  // magnitude of the coordinates that it was computed from
};

// Prepares a traversal by one to four rays of equal direction; `range` is in metres along them. Returns false
// if they miss the tree's bounds. Sets all of `q` but its positions.
bool prepare_rays(const TreeStore& tree, std::span<const Pose> rays, Interval range, RayQuery& q) {
  KERF_ASSERT(!rays.empty() && rays.size() <= kBlockWidth);
  const __m128 direction = to_floats(rays[0].direction);
  _mm_store_ps(q.direction, direction);
  const Passing own(tree.frame, rays[0]);
  _mm_store_ps(q.passing[0], own.point);
  __m128 low = own.point, high = own.point;
  double far = own.far, earliest = own.at, latest = own.at, nearest = own.distance2();
  for (size_t i = 1; i < rays.size(); ++i) {
    KERF_ASSERT(rays[i].direction == rays[0].direction);
    const Passing other(tree.frame, rays[i]);
    _mm_store_ps(q.passing[i], other.point);
    low = _mm_min_ps(low, other.point);
    high = _mm_max_ps(high, other.point);
    far = std::max(far, other.far);
    earliest = std::min(earliest, other.at);
    latest = std::max(latest, other.at);
    nearest = std::min(nearest, other.distance2());
  }
  const double reach = tree.reach(), scale = tree.frame.scale;
  const double lost = kBoxSlack * (8 * reach + far), error = reach * kPlaneRoundings + lost;
  // Rays from so far away that rounding decides their path hit nothing; beyond, floats overflow.
  constexpr double kMaxError = 1e30;
  if (!(error < kMaxError) || nearest > (reach + error) * (reach + error)) return false;
  // t = 0 is a plane across the rays in front of all boxes.
  const auto back = static_cast<float>(2 * reach);
  const __m128 ahead = _mm_mul_ps(_mm_set1_ps(back), direction);
  const __m128 slack = _mm_set1_ps(static_cast<float>(error));
  set_slabs(q, direction, _mm_sub_ps(_mm_sub_ps(low, ahead), slack),
            _mm_add_ps(_mm_sub_ps(high, ahead), slack));
  q.t_low =
      static_cast<float>(std::max(back - latest + range.low * scale - 2 * error, kMinRayParameter * reach));
  q.t_high = static_cast<float>(std::min(back - earliest + range.high * scale + 2 * error, 4 * reach));
  q.t_sure = static_cast<float>(back - own.at + range.low * scale + 4 * error);
  q.error = static_cast<float>(reach * kShearedRoundings + 2 * lost);
  q.rays = static_cast<uint32_t>(rays.size());
  return may_meet(q, tree.root_box());
}

bool nearer(const RayHit& a, const RayHit& b) {
  return a.length != b.length ? a.length < b.length : a.face < b.face;
}

Triangle triangle_of(Positions positions, const FaceBlock& block, unsigned lane) {
  return {positions[block.vertex[0][lane]], positions[block.vertex[1][lane]],
          positions[block.vertex[2][lane]]};
}

// Returns the crossing of a listed face, or nullopt if there is none within the range.
std::optional<RayHit> test_face(Positions positions, const ShearedRay& ray, Interval range, uintptr_t word) {
  const FaceBlock& block = *block_of(word);
  const unsigned lane = lane_of(word);
  const auto length = ray.cross(triangle_of(positions, block, lane));
  if (!length || !(*length >= range.low && *length <= range.high)) return std::nullopt;
  return RayHit{FaceId(block.face[lane]), *length};
}

void sort_from(std::vector<RayHit>& hits, size_t first) {
  if (hits.size() - first > 1)
    std::sort(hits.begin() + static_cast<std::ptrdiff_t>(first), hits.end(), nearer);
}

}  // namespace

void AabbTree::crossings(const Mesh& mesh, const Pose& ray, Interval range, std::vector<RayHit>& out) const {
  KERF_ASSERT(is_unit(ray.direction));
  if (store_.root == kNoIndex) return;
  RayQuery query;
  query.positions = reinterpret_cast<const char* const*>(mesh.positions().chunks());
  if (!prepare_rays(store_, {&ray, 1}, range, query)) return;
  WalkScratch scratch;
  walks_->ray(store_.view(), query, scratch);
  if (scratch.found().empty()) return;
  const ShearedRay sheared(ray);
  const size_t first = out.size();
  for (const uintptr_t word : scratch.found()) {
    if (const auto hit = test_face(mesh.positions(), sheared, range, word)) out.push_back(*hit);
  }
  sort_from(out, first);
}

void AabbTree::crossings(const Mesh& mesh, std::span<const Pose> rays, Interval range,
                         std::span<std::vector<RayHit>> out) const {
  KERF_ASSERT(out.size() == rays.size());
  const auto parallel = [&](const Pose& ray) { return ray.direction == rays[0].direction; };
  if (store_.root == kNoIndex || rays.empty()) return;
  if (rays.size() > kBlockWidth || !std::all_of(rays.begin(), rays.end(), parallel)) {
    for (size_t i = 0; i < rays.size(); ++i) crossings(mesh, rays[i], range, out[i]);
    return;
  }
  RayQuery query;
  query.positions = reinterpret_cast<const char* const*>(mesh.positions().chunks());
  if (!prepare_rays(store_, rays, range, query)) return;
  WalkScratch scratch;
  walks_->rays(store_.view(), query, scratch);
  if (scratch.found().empty()) return;
  ShearedRay sheared[kBlockWidth];
  for (size_t i = 0; i < rays.size(); ++i)
    sheared[i] = i == 0 ? ShearedRay(rays[0]) : sheared[0].beside(rays[i]);
  size_t first[kBlockWidth];
  for (size_t i = 0; i < rays.size(); ++i) first[i] = out[i].size();
  for (const uintptr_t word : scratch.found()) {
    const unsigned r = ray_of(word);
    if (const auto hit = test_face(mesh.positions(), sheared[r], range, word)) out[r].push_back(*hit);
  }
  for (size_t i = 0; i < rays.size(); ++i) sort_from(out[i], first[i]);
}

std::optional<RayHit> AabbTree::nearest(const Mesh& mesh, const Pose& ray, Interval range) const {
  KERF_ASSERT(is_unit(ray.direction));
  if (store_.root == kNoIndex) return std::nullopt;
  RayQuery query;
  query.positions = reinterpret_cast<const char* const*>(mesh.positions().chunks());
  if (!prepare_rays(store_, {&ray, 1}, range, query)) return std::nullopt;
  WalkScratch scratch;
  walks_->nearest(store_.view(), query, scratch);
  if (scratch.found().empty()) return std::nullopt;
  const ShearedRay sheared(ray);
  std::optional<RayHit> best;
  for (const uintptr_t word : scratch.found()) {
    const auto hit = test_face(mesh.positions(), sheared, range, word);
    if (hit && (!best || nearer(*hit, *best))) best = hit;
  }
  return best;
}

}  // namespace kerf
