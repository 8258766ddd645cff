#include <algorithm>
#include <queue>
#include <tuple>
#include <utility>

#include "core/walls/wall_mesh_internal.h"

namespace kerf {

namespace {

// Max ratio of the shortest to the longest side of a thin triangle; the second on a bent wall.
constexpr double kThin = 1.0 / 4, kThinBent = 1.0 / 16;
// A triangle with height below this share of its shorter sides is flat, not thin: no split improves it.
constexpr double kFlat = 1e-3;
// Max number of vertices that grading may add per vertex.
constexpr size_t kMaxGraded = 4;

}  // namespace

// Returns the longest side of a thin triangle whose two long sides are inner ones.
std::optional<WallMesh::LongSide> WallMesh::long_side(uint32_t triangle) const {
  const Corners& c = triangles_[triangle];
  std::array<double, 3> length;
  for (uint32_t i = 0; i < 3; ++i) length[i] = glm::length(vertices_[c[(i + 1) % 3]].at - vertices_[c[i]].at);
  const auto least = static_cast<uint32_t>(std::min_element(length.begin(), length.end()) - length.begin());
  const uint32_t one = (least + 1) % 3, other = (least + 2) % 3;
  const uint32_t longest = length[one] >= length[other] ? one : other;
  if (length[least] >= kThin * length[longest]) return std::nullopt;
  if (across_[triangle][one] == kNone || across_[triangle][other] == kNone) return std::nullopt;
  return LongSide{length[longest], length[least], edge(triangle, longest)};
}

// Returns true if an edge across this one, twice as wide as the adjacent triangles, would not deviate.
bool WallMesh::is_flat_around(const Quad& q, const Middle& middle) const {
  const Vertex &a = vertices_[q.a], &b = vertices_[q.b];
  const Vec3 along = b.at - a.at;
  const auto beyond = [&](uint32_t v, int64_t x) {
    const double share =
        std::clamp(glm::dot(vertices_[v].at - a.at, along) / glm::dot(along, along), 0.0, 1.0);
    const auto from_edge = [&](int64_t at, int64_t from, int64_t to) {
      return at - from - static_cast<int64_t>(share * static_cast<double>(to - from));
    };
    return ChartVertex{
        q.xa + (q.xb - q.xa) / 2 + 2 * from_edge(x, q.xa, q.xb),
        a.chart.y + (b.chart.y - a.chart.y) / 2 + 2 * from_edge(vertices_[v].chart.y, a.chart.y, b.chart.y)};
  };
  const ChartVertex left = beyond(q.c, q.xc), right = beyond(q.d, q.xd);
  const auto from = middle(within(left)), to = middle(within(right));
  return from && to && deviation_({*from, left}, {*to, right}) <= most_;
}

// Returns true if a point lies in the diametral sphere of a side of the boundary (J. Ruppert: A Delaunay
// refinement algorithm for quality 2-dimensional mesh generation, 1995).
bool WallMesh::encroaches(const Quad& q, const Vec3& p) const {
  const std::array<std::pair<uint32_t, uint32_t>, 4> sides{{{q.b, q.c}, {q.c, q.a}, {q.a, q.d}, {q.d, q.b}}};
  for (size_t i = 0; i < 4; ++i) {
    const Vec3 from = vertices_[sides[i].first].at, to = vertices_[sides[i].second].at;
    if (q.beyond[i] == kNone && glm::dot(from - p, to - p) < 0) return true;
  }
  return false;
}

// Returns the point that splits the longest side of a thin triangle: its middle, unless that is too near to
// the boundary, or nearer to another vertex than the ends of a short side may be to each other.
std::optional<Vec3> WallMesh::split_for_shape(const Quad& q, double shortest, const Middle& middle) const {
  const Vec3 a = vertices_[q.a].at, b = vertices_[q.b].at;
  const double length = glm::length(b - a);
  const auto is_flat = [&](uint32_t v) {
    const Vec3 to_a = a - vertices_[v].at, to_b = b - vertices_[v].at;
    const double height = glm::length(glm::cross(to_a, to_b)) / length;
    return height < kFlat * std::min(glm::length(to_a), glm::length(to_b));
  };
  if (is_flat(q.c)) return std::nullopt;
  const std::optional<Vec3> at = middle(middle_of(q));
  const auto is_far = [&](uint32_t v, double share) {
    return glm::length(vertices_[v].at - *at) >= share * length;
  };
  const auto is_well_shaped = [&](double thinnest) {
    return shortest < thinnest * length && is_far(q.c, thinnest) && is_far(q.d, thinnest);
  };
  if (!at || !is_far(q.a, kThin) || !is_far(q.b, kThin) || encroaches(q, *at)) return std::nullopt;
  const bool if_flat = is_well_shaped(kThin), if_bent = is_well_shaped(kThinBent);
  const bool splits = if_flat == if_bent ? if_flat : is_flat_around(q, middle) ? if_flat : if_bent;
  return splits ? at : std::nullopt;
}

Task<Done> WallMesh::grade(double least, const Middle& middle) {
  const auto is_less = [](const LongSide& a, const LongSide& b) {
    return std::tie(a.length, a.edge.from, a.edge.to) < std::tie(b.length, b.edge.from, b.edge.to);
  };
  std::priority_queue<LongSide, std::vector<LongSide>, decltype(is_less)> waiting(is_less);
  const auto look_at = [&](uint32_t triangle) {
    const auto side = long_side(triangle);
    if (side && side->length > least) waiting.push(*side);
  };
  for (uint32_t t = 0; t < triangles_.size(); ++t) {
    look_at(t);
    co_await yield_after(1);
  }
  const size_t most = (1 + kMaxGraded) * vertices_.size();
  while (!waiting.empty() && vertices_.size() < most) {
    const LongSide next = waiting.top();
    waiting.pop();
    co_await yield_after(4);
    if (!is_current(next.edge) || !is_inner(next.edge)) continue;
    const Quad q = quad_of(next.edge);
    const std::optional<Vec3> at = split_for_shape(q, next.shortest, middle);
    if (!at) continue;
    split(q, *at);
    const auto first = static_cast<uint32_t>(triangles_.size()) - 2;
    std::vector<uint32_t> changed{q.left, q.right, first, first + 1};
    const std::vector<Edge> turned =
        flip_from({edge(q.left, 2), edge(q.right, 2), edge(first, 1), edge(first + 1, 1)});
    for (const Edge& e : turned) {
      if (is_current(e)) changed.insert(changed.end(), {e.triangle, across_[e.triangle][e.side]});
    }
    for (const uint32_t t : changed) look_at(t);
  }
  co_return Done{};
}

}  // namespace kerf
