#include "core/walls/wall_mesh.h"

#include <algorithm>
#include <optional>

#include "core/base/assert.h"

namespace kerf {

namespace {

constexpr uint32_t kNone = 0xffffffffu;
// Flips end by themselves in a plane; on a wall that is bent they are limited to so many for each edge.
constexpr size_t kMostFlips = 16;
// // A flip must reduce the deviation to less than this share.
constexpr double kLeastGain = 0.99;
// The angles must exceed pi by more than what rounding does.
constexpr double kFlipSlack = 1e-9;

}  // namespace

WallMesh::WallMesh(std::vector<Vertex> vertices, std::span<const ChartTriangle> triangles, int64_t width,
                   Deviation deviation)
    : vertices_(std::move(vertices)), width_(width), deviation_(std::move(deviation)) {
  for (const ChartTriangle& t : triangles) {
    triangles_.emplace_back();
    set(static_cast<uint32_t>(triangles_.size() - 1), t);
  }
}

uint32_t WallMesh::triangle_on(uint32_t from, uint32_t to) const {
  const auto at = sides_.find({from, to});
  return at != sides_.end() ? at->second : kNone;
}

uint32_t WallMesh::opposite(uint32_t triangle, uint32_t from, uint32_t to) const {
  for (const uint32_t v : triangles_[triangle]) {
    if (v != from && v != to) return v;
  }
  KERF_ASSERT(false);
  return kNone;
}

void WallMesh::set(uint32_t triangle, const ChartTriangle& corners) {
  triangles_[triangle] = corners;
  for (size_t i = 0; i < 3; ++i) sides_[{corners[i], corners[(i + 1) % 3]}] = triangle;
}

void WallMesh::forget(uint32_t triangle) {
  const ChartTriangle& t = triangles_[triangle];
  for (size_t i = 0; i < 3; ++i) sides_.erase({t[i], t[(i + 1) % 3]});
}

bool WallMesh::is_inner(uint32_t from, uint32_t to) const {
  return triangle_on(from, to) != kNone && triangle_on(to, from) != kNone;
}

std::vector<WallMesh::Side> WallMesh::inner_edges() const {
  std::vector<Side> edges;
  for (const auto& [side, triangle] : sides_) {
    if (side.first < side.second && sides_.contains({side.second, side.first})) edges.push_back(side);
  }
  return edges;
}

bool WallMesh::should_flip(uint32_t a, uint32_t b) const {
  if (!is_inner(a, b)) return false;
  const uint32_t c = opposite(triangle_on(a, b), a, b), d = opposite(triangle_on(b, a), a, b);
  if (c == d || triangle_on(c, d) != kNone || triangle_on(d, c) != kNone) return false;
  const auto from_a = [&](uint32_t v) {
    return ChartVertex{x_between(vertices_[a].chart, vertices_[v].chart, width_),
                       vertices_[v].chart.y - vertices_[a].chart.y};
  };
  const ChartVertex to_b = from_a(b), to_c = from_a(c), to_d = from_a(d);
  const Wide at_a = turn_of(to_d.x, to_d.y, to_c.x, to_c.y);
  const Wide at_b = turn_of(to_c.x - to_b.x, to_c.y - to_b.y, to_d.x - to_b.x, to_d.y - to_b.y);
  if (at_a <= 0 || at_b <= 0) return false;
  const double now = deviation_(vertices_[a], vertices_[b]), then = deviation_(vertices_[c], vertices_[d]);
  if (now > 0 || then > 0) return then < kLeastGain * now;
  const auto corner = [&](uint32_t v) {
    const Vec3 p = vertices_[a].at - vertices_[v].at, q = vertices_[b].at - vertices_[v].at;
    return Vec2(glm::dot(p, q), glm::length(glm::cross(p, q)));  // cosine and sine, times the lengths
  };
  const Vec2 at_c = corner(c), at_d = corner(d);
  const double sine_of_sum = at_c.x * at_d.y + at_c.y * at_d.x;
  return sine_of_sum < -kFlipSlack * glm::length(at_c) * glm::length(at_d);
}

void WallMesh::flip(uint32_t a, uint32_t b) {
  const uint32_t left = triangle_on(a, b), right = triangle_on(b, a);
  const uint32_t c = opposite(left, a, b), d = opposite(right, a, b);
  forget(left);
  forget(right);
  set(left, {a, d, c});
  set(right, {d, b, c});
}

std::vector<WallMesh::Side> WallMesh::flip_from(std::vector<Side> waiting) {
  std::vector<Side> made;
  const size_t most = kMostFlips * triangles_.size();
  while (!waiting.empty() && made.size() < most) {
    const auto [a, b] = waiting.back();
    waiting.pop_back();
    if (!should_flip(a, b)) continue;
    const uint32_t c = opposite(triangle_on(a, b), a, b), d = opposite(triangle_on(b, a), a, b);
    flip(a, b);
    made.push_back({std::min(c, d), std::max(c, d)});
    for (const Side& side : {Side{a, d}, Side{d, b}, Side{b, c}, Side{c, a}}) waiting.push_back(side);
  }
  return made;
}

void WallMesh::improve() { flip_from(inner_edges()); }

void WallMesh::split(uint32_t a, uint32_t b, const Vertex& at) {
  const uint32_t left = triangle_on(a, b), right = triangle_on(b, a);
  const uint32_t c = opposite(left, a, b), d = opposite(right, a, b);
  const auto m = static_cast<uint32_t>(vertices_.size());
  vertices_.push_back(at);
  forget(left);
  forget(right);
  set(left, {a, m, c});
  set(right, {b, m, d});
  triangles_.resize(triangles_.size() + 2);
  const auto next = static_cast<uint32_t>(triangles_.size());
  set(next - 2, {m, b, c});
  set(next - 1, {m, a, d});
}

void WallMesh::refine(const Middle& middle) {
  std::vector<Side> waiting = inner_edges();
  while (!waiting.empty()) {
    std::vector<Side> next, around;
    for (const auto& [a, b] : waiting) {
      if (!is_inner(a, b)) continue;
      if (!(deviation_(vertices_[a], vertices_[b]) > 0)) continue;
      const std::optional<Vertex> at = middle(vertices_[a], vertices_[b]);
      if (!at) continue;
      const uint32_t c = opposite(triangle_on(a, b), a, b), d = opposite(triangle_on(b, a), a, b);
      const auto m = static_cast<uint32_t>(vertices_.size());
      split(a, b, *at);
      for (const uint32_t v : {a, b, c, d}) next.push_back({v, m});
      for (const Side& side : {Side{a, d}, Side{d, b}, Side{b, c}, Side{c, a}}) around.push_back(side);
    }
    const std::vector<Side> turned = flip_from(std::move(around));
    next.insert(next.end(), turned.begin(), turned.end());
    std::sort(next.begin(), next.end());
    next.erase(std::unique(next.begin(), next.end()), next.end());
    waiting = std::move(next);
  }
}

void WallMesh::split_between(uint32_t fixed, const std::function<bool(uint32_t, uint32_t)>& splits,
                             const Middle& middle) {
  for (const auto& [a, b] : inner_edges()) {
    if (a >= fixed || b >= fixed || !is_inner(a, b) || !splits(a, b)) continue;
    if (const std::optional<Vertex> at = middle(vertices_[a], vertices_[b])) split(a, b, *at);
  }
}

}  // namespace kerf
