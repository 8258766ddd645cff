#include "core/tree/queries.h"

#include <algorithm>
#include <bit>
#include <cassert>
#include <cmath>
#include <cstdint>
#include <limits>

#include "core/base/assert.h"
#include "core/base/geometry.h"
#include "core/base/random.h"
#include "core/base/tolerances.h"
#include "core/tree/tree_internal.h"
#include "core/tree/walks.h"

namespace kerf {

namespace {

// Returns an axis interval of the beam's slab in the frame of the tree, widened by all rounding errors.
SlabQuery::Axis tree_axis(const TreeStore& tree, double reach, const Vec3& axis, const Vec3& slab_origin,
                          Interval interval) {
  SlabQuery::Axis a;
  for (uint32_t k = 0; k < 3; ++k) {
    a.direction[k] = static_cast<float>(axis[static_cast<int>(k)]);
    a.low_plane[k] = a.direction[k] >= 0 ? k : k + 3;
    a.high_plane[k] = a.direction[k] >= 0 ? k + 3 : k;
  }
  const double scale = tree.frame.scale;
  const Vec3 from = (slab_origin - tree.frame.origin) * scale;
  const double base = glm::dot(axis, from), low = interval.low * scale, high = interval.high * scale;
  const double slack =
      reach * kProjectionRoundings + kBoxSlack * (8 * reach + std::abs(from.x) + std::abs(from.y) +
                                                  std::abs(from.z) + std::abs(low) + std::abs(high));
  const double most = 8 * reach;
  a.low = static_cast<float>(std::clamp(base + low - slack, -most, most));
  a.high = static_cast<float>(std::clamp(base + high + slack, -most, most));
  return a;
}

using Side = TouchedWalk::Side;
using Outcome = TouchedWalk::Outcome;

constexpr std::array<std::pair<int, Side>, 3> kOrder{
    {{1, Side::kMotion}, {2, Side::kLateral}, {0, Side::kDepth}}};

float projection(const SlabQuery::Axis& a, const std::array<float, 3>& p) {
  return a.direction[0] * p[0] + a.direction[1] * p[1] + a.direction[2] * p[2];
}

// Returns the interval that the box misses; planes in the order low x, y, z, high x, y, z.
Side missed_by(const SlabQuery& q, const std::array<float, 6>& plane) {
  for (const auto& [index, side] : kOrder) {
    const SlabQuery::Axis& a = q.axis[index];
    const auto sum = [&](const uint32_t(&at)[3]) {
      return projection(a, {plane[at[0]], plane[at[1]], plane[at[2]]});
    };
    if (!(sum(a.low_plane) <= a.high && a.low <= sum(a.high_plane))) return side;
  }
  return Side::kNone;
}

Side missed_by(const SlabQuery& q, const FaceBlock& block, uint32_t lane) {
  for (const auto& [index, side] : kOrder) {
    const SlabQuery::Axis& a = q.axis[index];
    std::array<float, 3> p{};
    for (size_t i = 0; i < 3; ++i)
      p[i] = projection(a, {block.corner[i][0][lane], block.corner[i][1][lane], block.corner[i][2][lane]});
    const auto [low, high] = std::minmax_element(p.begin(), p.end());
    if (!(*low <= a.high && a.low <= *high)) return side;
  }
  return Side::kNone;
}

std::array<float, 6> planes_of(const WideNode& node, uint32_t slot) {
  std::array<float, 6> planes{};
  for (size_t k = 0; k < 6; ++k) planes[k] = node.plane[k][slot];
  return planes;
}

// Returns the planes as in the query, i.e. without rounding outward.
std::array<float, 6> planes_of(const FaceBlock& block, uint32_t lane) {
  std::array<float, 6> planes{};
  for (size_t k = 0; k < 3; ++k) {
    const float a = block.corner[0][k][lane], b = block.corner[1][k][lane], c = block.corner[2][k][lane];
    planes[k] = std::min({a, b, c});
    planes[k + 3] = std::max({a, b, c});
  }
  return planes;
}

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

static_assert(RayQuery::kPositionShift == Positions::kShift && sizeof(Vec3) == 24);

Float4 to_floats(const Vec3& v) { return narrow_lanes(v.x, v.y, v.z); }

// Returns the mask of lanes with a sign, that of -0 included.
Int4 signs(Float4 v) { return std::bit_cast<Int4>(v) < all_lanes(INT32_C(0)); }

// Prepares the slab test for rays of direction d that start between `low` and `high` at t = 0, by axis.
void set_slabs(RayQuery& q, Float4 d, Float4 low, Float4 high) {
  const Int4 down = signs(d);
  const Float4 steep = 1 / max_lanes(abs_lanes(d), all_lanes(kMinComponent)), slope = down ? -steep : steep;
  const Float4 near_slope = slope * (1 - kSlopeRoundings), far_slope = slope * (1 + kSlopeRoundings);
  store_lanes(q.near_slope, near_slope);
  store_lanes(q.far_slope, far_slope);
  store_lanes(q.near_offset, (down ? low : high) * near_slope);
  store_lanes(q.far_offset, (down ? high : low) * far_slope);
  const Int4 lows{0, 1, 2, 3}, highs{3, 4, 5, 6};
  store_lanes(q.near_plane, down ? highs : lows);
  store_lanes(q.far_plane, down ? lows : highs);
}

bool may_meet(const RayQuery& q, const FloatBox& box) {
  const Int4 down = signs(load_lanes(q.direction));
  const Float4 near = down ? box.high : box.low, far = down ? box.low : box.high;
  Float4 entry = near * load_lanes(q.near_slope) - load_lanes(q.near_offset);
  Float4 exit = far * load_lanes(q.far_slope) - load_lanes(q.far_offset);
  // Compares every entry with every exit, including the limits of the range.
  entry[3] = q.t_low;
  exit[3] = q.t_high;
  exit = min_lanes(exit, __builtin_shufflevector(exit, exit, 1, 0, 3, 2));
  exit = min_lanes(exit, __builtin_shufflevector(exit, exit, 2, 3, 0, 1));
  return mask_bits(entry <= exit) == 15;
}

// The point of a ray nearest to the origin of the tree's frame.
struct Passing {
  Passing(const TreeFrame& frame, const Pose& ray) {
    const Vec3 start = frame.to_tree(ray.origin);
    at = -glm::dot(start, ray.direction);
    point = to_floats(start + at * ray.direction);
    far = std::abs(start.x) + std::abs(start.y) + std::abs(start.z);
  }
  double distance2() const { return point[0] * point[0] + point[1] * point[1] + point[2] * point[2]; }

  Float4 point;
  double at;   // parameter along the ray
  double far;  // magnitude of the coordinates that it was computed from
};

// Prepares a traversal by one to four rays of equal direction; `range` is in metres along them. Returns false
// if they miss the tree's bounds. Sets all of `q` but its positions.
bool prepare_rays(const TreeStore& tree, std::span<const Pose> rays, Interval range, RayQuery& q) {
  KERF_ASSERT(!rays.empty() && rays.size() <= kBlockWidth);
  const Float4 direction = to_floats(rays[0].direction);
  store_lanes(q.direction, direction);
  const Passing own(tree.frame, rays[0]);
  store_lanes(q.passing[0], own.point);
  Float4 low = own.point, high = own.point;
  double far = own.far, earliest = own.at, latest = own.at, nearest = own.distance2();
  for (size_t i = 1; i < rays.size(); ++i) {
    KERF_ASSERT(rays[i].direction == rays[0].direction);
    const Passing other(tree.frame, rays[i]);
    store_lanes(q.passing[i], other.point);
    low = min_lanes(low, other.point);
    high = max_lanes(high, other.point);
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
  const Float4 ahead = back * direction;
  const auto slack = static_cast<float>(error);
  set_slabs(q, direction, low - ahead - slack, high - ahead + slack);
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

// Clamps depths to the tree, so that the far end of a tilting beam does not widen the slab. Computes with
// differences from the origin of the frame: coordinates of the mesh may be too coarse for the middle of the
// tree.
SlabQuery beam_slab(const TreeStore& tree, const SweptCylinder& beam) {
  assert(tree.root != kNoIndex);
  const auto metres = [&](Float4 p) { return Vec3(p[0], p[1], p[2]) / tree.frame.scale; };
  const Vec3 low = metres(tree.root_box().low), high = metres(tree.root_box().high);
  const SweptCylinder::Slab open =
      beam.slab({std::numeric_limits<double>::lowest(), std::numeric_limits<double>::max()});
  const Vec3 centre = (tree.frame.origin - open.origin) + (0.5 * low + 0.5 * high), half = 0.5 * (high - low);
  const double depth = glm::dot(open.axis, centre),
               deep = (1 + kBoxSlack) * glm::dot(glm::abs(open.axis), half);
  const SweptCylinder::Slab slab = beam.slab({depth - deep, depth + deep});
  const double reach = tree.reach();
  return {{tree_axis(tree, reach, slab.axis, slab.origin, slab.depth),
           tree_axis(tree, reach, slab.along, slab.origin, slab.motion),
           tree_axis(tree, reach, slab.across, slab.origin, slab.lateral)}};
}

QueryCounts AabbTree::touched(const Mesh& mesh, const SweptCylinder& beam, std::vector<FaceId>& out,
                              std::vector<FaceId>* near) const {
  QueryCounts counts;
  if (store_.root == kNoIndex) return counts;
  const SlabQuery query = beam_slab(store_, beam);
  WalkScratch scratch;
  counts.boxes = walks_->slab(store_.view(), query, scratch);
  counts.faces = scratch.found().size();
  const auto face = [](uintptr_t word) { return FaceId(block_of(word)->face[lane_of(word)]); };
  if (near) {
    for (const uintptr_t word : scratch.met()) near->push_back(face(word));
  }
  const size_t first = out.size();
  for (const uintptr_t word : scratch.found()) {
    if (beam.touches(mesh.triangle(face(word)))) out.push_back(face(word));
  }
  Shuffle::selected().reorder(out, first);
  return counts;
}

// Traverses nodes breadth-first and blocks after them, in the order of the query.
class TouchedTrace {
 public:
  TouchedTrace(const AabbTree& tree, const Mesh& mesh, const SweptCylinder& beam)
      : tree_(tree), mesh_(mesh), beam_(beam), slab_(beam_slab(tree.store_, beam)) {}

  static std::optional<TreeSlot> slot_of(const AabbTree& tree, const Mesh& mesh, FaceId face) {
    const uint32_t place = tree.store_.place(face);
    if (place == kNoIndex) return std::nullopt;
    const uint32_t block = place / kBlockWidth, lane = place % kBlockWidth;
    return TreeSlot{block, lane, mesh.data(face).hit};
  }

  TouchedWalk run() {
    const TreeStore& store = tree_.store_;
    add(tree_.box_of(store.root_box(), 0, false, false), TouchedWalk::kNoParent, Side::kNone);
    nodes_.push_back({store.root, 0});
    for (size_t i = 0; i < nodes_.size(); ++i) open_node(nodes_[i]);
    for (const Place& block : blocks_) open_block(block);
    std::sort(walk_.touched.begin(), walk_.touched.end());
    return std::move(walk_);
  }

 private:
  struct Place {
    uint32_t record;  // node or block
    uint32_t visit;   // of its box
  };

  uint32_t add(const AabbTree::Box& box, uint32_t parent, Side outside) {
    walk_.visits.push_back(
        {box, parent, outside == Side::kNone ? Outcome::kEntered : Outcome::kCulled, outside, {}});
    return static_cast<uint32_t>(walk_.visits.size() - 1);
  }

  void open_node(Place at) {
    const TreeStore& store = tree_.store_;
    const WideNode& node = store.nodes[at.record];
    walk_.counts.boxes += kNodeWidth;
    for (uint32_t s = 0; s < kNodeWidth; ++s) {
      const Child child = node.child[s];
      if (child.none()) continue;
      const int depth = walk_.visits[at.visit].box.depth + 1;
      const Side outside = missed_by(slab_, planes_of(node, s));
      const uint32_t visit =
          add(tree_.box_of(store.slot_box(at.record, s), depth, false, false), at.visit, outside);
      if (outside != Side::kNone) continue;
      (child.is_block() ? blocks_ : nodes_).push_back({child.index(), visit});
    }
  }

  void open_block(Place at) {
    const TreeStore& store = tree_.store_;
    const FaceBlock& block = store.blocks[at.record];
    walk_.counts.boxes += block.count;
    for (uint32_t lane = 0; lane < block.count; ++lane) {
      const bool hit = mesh_.data(FaceId(block.face[lane])).hit;
      const int depth = walk_.visits[at.visit].box.depth + 1;
      Side outside = missed_by(slab_, planes_of(block, lane));
      if (outside == Side::kNone) outside = missed_by(slab_, block, lane);
      const uint32_t visit =
          add(tree_.box_of(store.face_box(block, lane), depth, true, hit), at.visit, outside);
      walk_.visits[visit].face = FaceId(block.face[lane]);
      if (outside == Side::kNone) test_face(walk_.visits[visit]);
    }
  }

  void test_face(TouchedWalk::Visit& visit) {
    ++walk_.counts.faces;
    const bool touched = beam_.touches(mesh_.triangle(visit.face));
    visit.outcome = touched ? Outcome::kTouched : Outcome::kMissed;
    if (touched) walk_.touched.push_back(visit.face);
  }

  const AabbTree& tree_;
  const Mesh& mesh_;
  const SweptCylinder& beam_;
  SlabQuery slab_;
  std::vector<Place> nodes_, blocks_;
  TouchedWalk walk_;
};

std::optional<TreeSlot> tree_slot(const AabbTree& tree, const Mesh& mesh, FaceId face) {
  return TouchedTrace::slot_of(tree, mesh, face);
}

TouchedWalk trace_touched(const AabbTree& tree, const Mesh& mesh, const SweptCylinder& beam) {
  return tree.leaf_count() == 0 ? TouchedWalk{} : TouchedTrace(tree, mesh, beam).run();
}

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
  const double weighted = sum_in_order(a * z[0], b * z[1], c * z[2]);
  // Products of three lengths leave the range of doubles for triangles beyond 1e102 m or below 1e-90 m.
  constexpr double kMinPlain = 0x1p-600;  // m^2
  if (!(std::abs(sum) >= kMinPlain && std::isfinite(weighted)))
    return sum_in_order(a / sum * z[0], b / sum * z[1], c / sum * z[2]) * per_z_;
  return weighted / sum * per_z_;
}

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
