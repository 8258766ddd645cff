#include "core/mesh/files/triangulation.h"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "core/base/assert.h"

namespace kerf {

void PointTree::build(std::span<const Vec2> points, std::span<const uint32_t> selected) {
  KERF_ASSERT(std::all_of(selected.begin(), selected.end(), [&](uint32_t i) { return i < points.size(); }));
  items_.assign(selected.begin(), selected.end());
  nodes_.clear();
  if (!items_.empty()) build_node(0, {0, static_cast<uint32_t>(items_.size())}, points);
}

void PointTree::build_node(size_t node, Range range, std::span<const Vec2> points) {
  KERF_ASSERT(range.begin < range.end);
  if (node >= nodes_.size()) nodes_.resize(node + 1);
  Vec2 low = points[items_[range.begin]], high = low;
  for (uint32_t i = range.begin; i < range.end; ++i) {
    const Vec2 p = points[items_[i]];
    low = {std::min(low.x, p.x), std::min(low.y, p.y)};
    high = {std::max(high.x, p.x), std::max(high.y, p.y)};
  }
  nodes_[node] = {low, high, range.end - range.begin};
  if (range.is_leaf()) return;
  const int axis = high.x - low.x >= high.y - low.y ? 0 : 1;
  const auto at = [&](uint32_t i) { return items_.begin() + static_cast<std::ptrdiff_t>(i); };
  std::nth_element(at(range.begin), at(range.middle()), at(range.end),
                   [&](uint32_t a, uint32_t b) { return points[a][axis] < points[b][axis]; });
  build_node(2 * node + 1, {range.begin, range.middle()}, points);
  build_node(2 * node + 2, {range.middle(), range.end}, points);
}

// Tests for each edge the corner of the box that is farthest on its inner side, with the same operations as a
// point; since rounding is monotonic, no point of the box can yield a larger value.
bool PointTree::touches(const Node& node, const std::array<Vec2, 3>& triangle) {
  const auto [low_x, high_x] = std::minmax({triangle[0].x, triangle[1].x, triangle[2].x});
  const auto [low_y, high_y] = std::minmax({triangle[0].y, triangle[1].y, triangle[2].y});
  if (node.low.x > high_x || node.high.x < low_x || node.low.y > high_y || node.high.y < low_y) return false;
  for (size_t i = 0; i < 3; ++i) {
    const Vec2 from = triangle[i], along = triangle[(i + 1) % 3] - from;
    const Vec2 farthest(along.y > 0 ? node.low.x : node.high.x, along.x > 0 ? node.high.y : node.low.y);
    if (cross2(along, farthest - from) < 0) return false;
  }
  return true;
}

namespace {

// Maximum number of boxes and points tested per corner of a polygon; beyond it any corner counts as an ear.
// The worst simple polygons tried, of a hundred thousand corners, need 500 tests per corner.
constexpr uint64_t kWorkPerCorner = 2000;
constexpr uint64_t kMaxWork = 400'000'000;

double turn2(Vec2 a, Vec2 b, Vec2 c) { return cross2(b - a, c - a); }

}  // namespace

double EarClipper::turn(uint32_t i) const {
  return turn2(points_[previous_[i]], points_[i], points_[next_[i]]);
}

void EarClipper::start(std::span<const Vec2> points) {
  points_ = points;
  left_ = static_cast<uint32_t>(points.size());
  previous_.resize(left_);
  next_.resize(left_);
  blocker_.resize(left_);
  queued_.assign(left_, 0);
  touched_.assign(left_, 0);
  alive_.assign(left_, 1);
  for (uint32_t i = 0; i < left_; ++i) {
    previous_[i] = i == 0 ? left_ - 1 : i - 1;
    next_[i] = i + 1 == left_ ? 0 : i + 1;
  }
  waiting_.clear();
  fresh_.clear();
  round_ = 0;
  std::vector<uint32_t> selected;
  for (uint32_t i = 0; i < left_; ++i) {
    blocker_[i] = !(turn(i) > 0);
    if (blocker_[i]) selected.push_back(i);
  }
  tree_.build(points, selected);
  rule_ = Rule::kStrict;
  loosened_ = false;
  work_ = 0;
  max_work_ = std::min(kMaxWork, kWorkPerCorner * (left_ + uint64_t{1000}));
}

void EarClipper::enqueue(uint32_t i) {
  if (queued_[i]) return;
  queued_[i] = 1;
  fresh_.push_back(i);
}

void EarClipper::enqueue_all() {
  work_ += alive_.size();
  for (uint32_t i = 0; i < alive_.size(); ++i) {
    if (alive_[i]) enqueue(i);
  }
}

// Returns true if the edges at q, which coincides with the tip of the ear, lead into the ear: one of them
// into its interior, or both along its sides.
bool EarClipper::enters_wedge(uint32_t q, uint32_t ear) const {
  const Vec2 tip = points_[ear], out = points_[next_[ear]] - tip, back = points_[previous_[ear]] - tip;
  bool along = true;
  for (const uint32_t neighbour : {previous_[q], next_[q]}) {
    const Vec2 direction = points_[neighbour] - tip;
    const double from_out = cross2(out, direction), to_back = cross2(direction, back);
    if (from_out > 0 && to_back > 0) return true;
    along = along && from_out >= 0 && to_back >= 0;
  }
  return along;
}

bool EarClipper::blocks(uint32_t q, uint32_t ear) const {
  const Vec2 p = points_[q], a = points_[previous_[ear]], b = points_[ear], c = points_[next_[ear]];
  const double ab = turn2(a, b, p), bc = turn2(b, c, p), ca = turn2(c, a, p);
  if (rule_ == Rule::kTouching) return ab > 0 && bc > 0 && ca > 0;
  if (!(ab >= 0 && bc >= 0 && ca >= 0)) return false;
  // A chain that starts at an end of the cut and enters the ear has a corner inside that blocks by itself.
  if (p == a || p == c) return false;
  return p != b || enters_wedge(q, ear);
}

bool EarClipper::is_blocked(uint32_t i) {
  const std::array<Vec2, 3> ear{points_[previous_[i]], points_[i], points_[next_[i]]};
  return tree_.visit(ear, work_, [&](uint32_t q) {
    if (!blocker_[q]) return PointTree::Verdict::kForget;
    if (q == i || q == previous_[i] || q == next_[i]) return PointTree::Verdict::kPass;
    return blocks(q, i) ? PointTree::Verdict::kStop : PointTree::Verdict::kPass;
  });
}

bool EarClipper::is_ear(uint32_t i) {
  if (rule_ == Rule::kAny) return true;
  const double area = turn(i);
  if (rule_ == Rule::kFlat) return area == 0;
  return area > 0 && !is_blocked(i);
}

void EarClipper::remove(uint32_t i) {
  assert(alive_[i] && left_ > 3);
  const uint32_t before = previous_[i], after = next_[i];
  next_[before] = after;
  previous_[after] = before;
  alive_[i] = 0;
  blocker_[i] = 0;
  --left_;
  // A corner that became convex stays removed from the tree even if rounding makes it straight again.
  blocker_[before] = blocker_[before] && !(turn(before) > 0);
  blocker_[after] = blocker_[after] && !(turn(after) > 0);
  touched_[before] = touched_[after] = round_;
  enqueue(before);
  enqueue(after);
}

// No candidate is left: returns to the strict rule if a looser one found an ear, otherwise loosens the rule.
void EarClipper::change_rule() {
  if (rule_ != Rule::kAny) rule_ = loosened_ ? Rule::kStrict : static_cast<Rule>(static_cast<int>(rule_) + 1);
  loosened_ = false;
  enqueue_all();
}

// Ears are clipped in rounds, and no two neighbours in the same round: clipping neighbours in turn would
// create fans of long triangles, whose tests visit many boxes. Postponed candidates come first in the next
// round.
bool EarClipper::start_round() {
  queue_.assign(waiting_.begin(), waiting_.end());
  queue_.insert(queue_.end(), fresh_.begin(), fresh_.end());
  waiting_.clear();
  fresh_.clear();
  ++round_;
  return !queue_.empty();
}

void EarClipper::consider(uint32_t i, std::vector<std::array<uint32_t, 3>>& ears) {
  if (alive_[i] && touched_[i] == round_) return waiting_.push_back(i);
  queued_[i] = 0;
  if (!alive_[i] || !is_ear(i)) return;
  ears.push_back({previous_[i], i, next_[i]});
  loosened_ = rule_ != Rule::kStrict;
  remove(i);
}

void EarClipper::clip(std::span<const Vec2> points, std::vector<std::array<uint32_t, 3>>& ears) {
  assert(points.size() >= 3);
  start(points);
  enqueue_all();
  while (left_ > 3) {
    if (!start_round() || (rule_ == Rule::kTouching && loosened_)) change_rule();
    for (size_t i = 0; i < queue_.size() && left_ > 3; ++i) {
      if (work_ > max_work_) rule_ = Rule::kAny;
      consider(queue_[i], ears);
    }
  }
  const uint32_t rest = static_cast<uint32_t>(std::find(alive_.begin(), alive_.end(), 1) - alive_.begin());
  ears.push_back({previous_[rest], rest, next_[rest]});
}

namespace {

// Returns twice the signed area of the triangle of a polygon's corner i and its two neighbours.
double turn_at(std::span<const Vec2> points, size_t i) {
  const size_t n = points.size();
  const Vec2 before = points[(i + n - 1) % n], after = points[(i + 1) % n];
  return cross2(points[i] - before, after - before);
}

double largest_coordinate(std::span<const Vec3> points) {
  double largest = 0;
  for (const Vec3& p : points) largest = std::max({largest, std::abs(p.x), std::abs(p.y), std::abs(p.z)});
  return largest;
}

bool all_finite(std::span<const Vec3> points) {
  return std::all_of(points.begin(), points.end(), [](const Vec3& p) {
    return std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z);
  });
}

// Scales the coordinates by a power of two, which is exact, to a magnitude near 1, so that none of their
// products overflows or underflows.
void scale_to_one(std::span<Vec3> points) {
  const double largest = largest_coordinate(points);
  if (largest == 0) return;
  const double factor = std::ldexp(1.0, std::clamp(-std::ilogb(largest), -1000, 1000));
  for (Vec3& p : points) p *= factor;
}

// Newell's normal: the components are twice the areas of the projections onto the coordinate planes.
Vec3 newell_normal(std::span<const Vec3> points) {
  Vec3 normal(0);
  for (size_t i = 1; i + 1 < points.size(); ++i) {
    normal += glm::cross(points[i] - points[0], points[i + 1] - points[0]);
  }
  return normal;
}

// Projects along the axis of the normal's largest component and keeps the orientation counter-clockwise. The
// other two coordinates are unchanged, so that collinear points stay collinear.
void flatten(std::span<const Vec3> points, const Vec3& normal, std::vector<Vec2>& flat) {
  const Vec3 size(std::abs(normal.x), std::abs(normal.y), std::abs(normal.z));
  const int drop = size.x > size.y && size.x > size.z ? 0 : size.y > size.z ? 1 : 2;
  int u = (drop + 1) % 3, v = (drop + 2) % 3;
  if (normal[drop] < 0) std::swap(u, v);
  flat.clear();
  for (const Vec3& p : points) flat.emplace_back(p[u], p[v]);
}

// Returns true if every corner is strictly convex and the boundary winds around once.
bool is_strictly_convex(std::span<const Vec2> points) {
  int changes = 0;  // of the direction along x, a vertical edge counting as rightwards
  for (size_t i = 0; i < points.size(); ++i) {
    if (!(turn_at(points, i) > 0)) return false;
    const Vec2 a = points[i], b = points[(i + 1) % points.size()], c = points[(i + 2) % points.size()];
    changes += (b.x >= a.x) != (c.x >= b.x);
  }
  return changes <= 2;
}

}  // namespace

void Triangulator::split_into_fan(size_t corners) {
  for (uint32_t i = 1; i + 1 < corners; ++i) ears_.push_back({0, i, i + 1});
}

void Triangulator::split_quadrangle() {
  KERF_ASSERT(flat_.size() == 4);
  const double from_first = std::min(turn_at(flat_, 1), turn_at(flat_, 3));
  const double from_second = std::min(turn_at(flat_, 0), turn_at(flat_, 2));
  if (from_first > 0 || from_first >= from_second) return split_into_fan(4);
  ears_.push_back({1, 2, 3});
  ears_.push_back({1, 3, 0});
}

void Triangulator::split(std::span<const Vec3> positions, std::span<const uint32_t> polygon) {
  ears_.clear();
  if (polygon.size() <= 3) return split_into_fan(polygon.size());
  corners_.clear();
  for (const uint32_t v : polygon) {
    assert(v < positions.size());
    corners_.push_back(positions[v]);
  }
  if (!all_finite(corners_)) return split_into_fan(polygon.size());
  scale_to_one(corners_);
  flatten(corners_, newell_normal(corners_), flat_);
  if (polygon.size() == 4) return split_quadrangle();
  if (is_strictly_convex(flat_)) return split_into_fan(polygon.size());
  clipper_.clip(flat_, ears_);
}

void Triangulator::append(std::span<const Vec3> positions, std::span<const uint32_t> polygon,
                          std::vector<Soup::Triangle>& triangles) {
  split(positions, polygon);
  for (const auto& ear : ears_) triangles.push_back({polygon[ear[0]], polygon[ear[1]], polygon[ear[2]]});
}

void Triangulator::append_corners(size_t count, uint32_t first, std::vector<Soup::Triangle>& corners) const {
  KERF_ASSERT(count == ears_.size());
  for (const auto& ear : ears_) corners.push_back({first + ear[0], first + ear[1], first + ear[2]});
}

}  // namespace kerf
