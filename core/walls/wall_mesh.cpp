#include <algorithm>
#include <queue>
#include <tuple>

#include "core/base/assert.h"
#include "core/walls/wall_mesh_internal.h"

namespace kerf {

namespace {

// Max ratio of the shortest to the longest side of a thin triangle; the second on a bent wall.
constexpr double kThin = 1.0 / 4, kThinBent = 1.0 / 16;
// A triangle with height below this share of its shorter sides is flat, not thin: no split improves it.
constexpr double kFlat = 1e-3;
// Max number of vertices that grading may add per vertex.
constexpr size_t kMaxGraded = 4;

// Max flips per triangle. In a plane, flips terminate by themselves; on a bent wall they are limited.
constexpr size_t kMaxFlips = 16;
// A flip must reduce the deviation to less than this share.
constexpr double kMinGain = 0.99;
// An edge is not split if one part would be less than this share of it.
constexpr double kBesideEnd = 1.0 / 16;
// A flip makes no flatter triangle, in chart units: an edge through a vertex, but for rounding, would
// return.
constexpr int64_t kFlattest = 2;
// Initial capacity of lists, as a multiple of their size: copying a list that grows would be a long pause.
constexpr size_t kRoom = 4;
// The sum of the angles must exceed pi by more than rounding.
constexpr double kFlipSlack = 1e-9;

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

SideIndex::SideIndex(std::span<const std::array<uint32_t, 3>> triangles, size_t vertices)
    : first_(vertices + 1), sides_(3 * triangles.size()) {
  for (const auto& t : triangles) {
    for (const uint32_t v : t) {
      KERF_ASSERT(v < vertices);
      ++first_[v + 1];
    }
  }
  for (size_t v = 0; v < vertices; ++v) first_[v + 1] += first_[v];
  std::vector<uint32_t> next(first_.begin(), first_.end() - 1);
  for (uint32_t i = 0; i < triangles.size(); ++i) {
    const auto& t = triangles[i];
    for (uint32_t k = 0; k < 3; ++k) sides_[next[t[k]]++] = {t[(k + 1) % 3], i, k};
  }
}

const SideIndex::Side* SideIndex::find(uint32_t v, uint32_t to) const {
  for (const Side& s : from(v)) {
    if (s.to == to) return &s;
  }
  return nullptr;
}

const SideIndex::Side* SideIndex::find_repeated() const {
  for (uint32_t v = 0; v + 1 < first_.size(); ++v) {
    for (const Side& s : from(v)) {
      if (s.to == v || find(v, s.to) != &s) return &s;
    }
  }
  return nullptr;
}

WallMesh::WallMesh(std::vector<Vertex> vertices, std::span<const ChartTriangle> triangles, int64_t width,
                   Deviation deviation, double most)
    : vertices_(std::move(vertices)),
      across_(triangles.size(), {kNone, kNone, kNone}),
      is_pinched_(vertices_.size()),
      width_(width),
      deviation_(std::move(deviation)),
      most_(most),
      known_(triangles.size(), kUnknown) {
  KERF_ASSERT(width > 0 && most >= 0);
  vertices_.reserve(kRoom * vertices_.size());
  triangles_.reserve(kRoom * triangles.size());
  x_.reserve(kRoom * triangles.size());
  across_.reserve(kRoom * triangles.size());
  known_.reserve(kRoom * triangles.size());
  for (const ChartTriangle& t : triangles) {
    triangles_.push_back(t.corners);
    x_.push_back(t.x);
  }
  const SideIndex sides(triangles_, vertices_.size());
  std::vector<bool> starts_boundary(vertices_.size());
  for (uint32_t t = 0; t < triangles_.size(); ++t) {
    for (uint32_t i = 0; i < 3; ++i) {
      const uint32_t from = triangles_[t][i], to = triangles_[t][(i + 1) % 3];
      has_wide_edge_ = has_wide_edge_ || is_wide(x_[t][i], x_[t][(i + 1) % 3]);
      if (const SideIndex::Side* const other = sides.find(to, from)) {
        across_[t][i] = other->triangle;
      } else {
        is_pinched_[from] = starts_boundary[from];
        starts_boundary[from] = true;
      }
    }
  }
}

WallMesh::Edge WallMesh::edge(uint32_t triangle, uint32_t side) const {
  const Corners& t = triangles_[triangle];
  return {triangle, side, t[side], t[(side + 1) % 3]};
}

bool WallMesh::is_current(const Edge& e) const {
  const Corners& t = triangles_[e.triangle];
  return t[e.side] == e.from && t[(e.side + 1) % 3] == e.to;
}

uint32_t WallMesh::side_from(uint32_t triangle, uint32_t from) const {
  const Corners& t = triangles_[triangle];
  const auto at = static_cast<uint32_t>(std::find(t.begin(), t.end(), from) - t.begin());
  KERF_ASSERT(at < 3);
  return at;
}

WallMesh::Quad WallMesh::quad_of(const Edge& e) const {
  const uint32_t left = e.triangle, right = across_[left][e.side];
  const uint32_t a = e.side, b = (a + 1) % 3, c = (a + 2) % 3;  // corners of the left triangle
  const uint32_t back = side_from(right, e.to), to_a = (back + 1) % 3, d = (back + 2) % 3;
  Quad q{};
  q.left = left;
  q.right = right;
  q.a = e.from;
  q.b = e.to;
  q.c = triangles_[left][c];
  q.d = triangles_[right][d];
  q.xa = x_[left][a];
  q.xb = x_[left][b];
  q.xc = x_[left][c];
  q.xd = x_[right][d] + q.xa - x_[right][to_a];
  q.beyond = {across_[left][b], across_[left][c], across_[right][to_a], across_[right][d]};
  q.known = {known_[left][b], known_[left][c], known_[right][to_a], known_[right][d]};
  return q;
}

// Sets a triangle and links its neighbours to it.
void WallMesh::set(uint32_t triangle, const ChartTriangle& to, const std::array<uint32_t, 3>& across,
                   const std::array<double, 3>& known) {
  const Corners& corners = to.corners;
  triangles_[triangle] = corners;
  known_[triangle] = known;
  x_[triangle] = to.x;
  across_[triangle] = across;
  for (uint32_t i = 0; i < 3; ++i) {
    if (across[i] == kNone) continue;
    const Corners& other = triangles_[across[i]];
    for (uint32_t k = 0; k < 3; ++k) {
      if (other[k] == corners[(i + 1) % 3] && other[(k + 1) % 3] == corners[i])
        across_[across[i]][k] = triangle;
    }
  }
}

double WallMesh::deviation(uint32_t a, int64_t xa, uint32_t b, int64_t xb) const {
  const Vertex &from = vertices_[a], &to = vertices_[b];
  return deviation_({from.at, {xa, from.chart.y}}, {to.at, {xb, to.chart.y}});
}

// Returns the deviation of the edge between the triangles beyond the permitted one (m).
double WallMesh::excess(const Quad& q) {
  double& known = known_[q.left][side_from(q.left, q.a)];
  if (known < 0) known = known_[q.right][side_from(q.right, q.b)] = deviation(q.a, q.xa, q.b, q.xb);
  return std::max(known - most_, 0.0);
}

std::vector<WallMesh::Edge> WallMesh::inner_edges() const {
  std::vector<Edge> edges;
  for (uint32_t t = 0; t < triangles_.size(); ++t) {
    for (uint32_t i = 0; i < 3; ++i) {
      if (across_[t][i] != kNone && t < across_[t][i]) edges.push_back(edge(t, i));
    }
  }
  return edges;
}

// Returns true if a triangle of this triangle's fan around `from` has the corner `to`.
bool WallMesh::has_edge_to(uint32_t triangle, uint32_t from, uint32_t to) const {
  const auto contains = [&](uint32_t t) {
    return std::find(triangles_[t].begin(), triangles_[t].end(), to) != triangles_[t].end();
  };
  // Walks counter-clockwise, then clockwise if that reaches the boundary.
  uint32_t t = triangle;
  do {
    if (contains(t)) return true;
    t = across_[t][(side_from(t, from) + 2) % 3];
  } while (t != kNone && t != triangle);
  if (t == triangle) return false;
  for (t = across_[triangle][side_from(triangle, from)]; t != kNone; t = across_[t][side_from(t, from)]) {
    if (contains(t)) return true;
  }
  return false;
}

// Returns true if the opposite corners of two triangles have a common edge, or if that is hard to determine
// because each has several fans. If no triangle is folded, no edge lies within the two in the chart, so a
// common edge runs around the other way.
bool WallMesh::may_be_joined(const Quad& q) const {
  if (q.c == q.d) return true;
  if (!is_folded_ && !has_wide_edge_ && !is_wide(q.xc, q.xd)) return false;
  if (!is_pinched_[q.c]) return has_edge_to(q.left, q.c, q.d);
  return is_pinched_[q.d] || has_edge_to(q.right, q.d, q.c);
}

// Returns true if a triangle is counter-clockwise in the chart.
bool WallMesh::is_upright(uint32_t triangle) const {
  const auto& x = x_[triangle];
  const auto y = [&](size_t i) { return vertices_[triangles_[triangle][i]].chart.y; };
  return doubled_area(x[1] - x[0], y(1) - y(0), x[2] - x[0], y(2) - y(0)) > 0;
}

bool WallMesh::should_flip(const Quad& q) {
  const auto y_from_a = [&](uint32_t v) { return vertices_[v].chart.y - vertices_[q.a].chart.y; };
  const ChartVertex b{q.xb - q.xa, y_from_a(q.b)}, c{q.xc - q.xa, y_from_a(q.c)},
      d{q.xd - q.xa, y_from_a(q.d)};
  const Wide at_a = doubled_area(d.x, d.y, c.x, c.y);
  const Wide at_b = doubled_area(c.x - b.x, c.y - b.y, d.x - b.x, d.y - b.y);
  if (at_a <= 0 || at_b <= 0) return false;
  const Wide flat = kFlattest * (std::abs(c.x - d.x) + std::abs(c.y - d.y)), flattest = std::min(at_a, at_b);
  if (flattest <= flat &&
      flattest < std::min(doubled_area(b.x, b.y, c.x, c.y), doubled_area(d.x, d.y, b.x, b.y)))
    return false;
  const double now = excess(q);
  const auto then = [&] { return std::max(deviation(q.c, q.xc, q.d, q.xd) - most_, 0.0); };
  if (now > 0) return !may_be_joined(q) && then() < kMinGain * now;
  const auto corner = [&](uint32_t v) {
    const Vec3 to_a = vertices_[q.a].at - vertices_[v].at, to_b = vertices_[q.b].at - vertices_[v].at;
    return Vec2(glm::dot(to_a, to_b), glm::length(glm::cross(to_a, to_b)));  // cosine and sine, times lengths
  };
  const Vec2 at_c = corner(q.c), at_d = corner(q.d);
  const double sine_of_sum = at_c.x * at_d.y + at_c.y * at_d.x;
  if (!(sine_of_sum < -kFlipSlack * glm::length(at_c) * glm::length(at_d))) return false;
  return !may_be_joined(q) && then() == 0;
}

void WallMesh::flip(const Quad& q) {
  has_wide_edge_ = has_wide_edge_ || is_wide(q.xc, q.xd);
  set(q.left, {{q.a, q.d, q.c}, {q.xa, q.xd, q.xc}}, {q.beyond[2], q.right, q.beyond[1]},
      {q.known[2], -1, q.known[1]});
  set(q.right, {{q.d, q.b, q.c}, {q.xd, q.xb, q.xc}}, {q.beyond[3], q.beyond[0], q.left},
      {q.known[3], q.known[0], -1});
}

size_t WallMesh::max_flips() const { return kMaxFlips * triangles_.size(); }

// Removes the last edge from the list; if it should be flipped, flips it and adds the surrounding sides.
void WallMesh::flip_last(std::vector<Edge>& waiting, std::vector<Edge>& made) {
  const Edge e = waiting.back();
  waiting.pop_back();
  if (!is_current(e) || !is_inner(e)) return;
  const Quad q = quad_of(e);
  if (!should_flip(q)) return;
  flip(q);
  made.push_back(edge(q.left, 1));
  for (const Edge& side : {edge(q.left, 0), edge(q.left, 2), edge(q.right, 0), edge(q.right, 1)})
    waiting.push_back(side);
}

// Returns the edges made by flips.
std::vector<WallMesh::Edge> WallMesh::flip_from(std::vector<Edge> waiting) {
  std::vector<Edge> made;
  for (const size_t most = max_flips(); !waiting.empty() && made.size() < most;) flip_last(waiting, made);
  return made;
}

Task<std::vector<WallMesh::Edge>> WallMesh::flip_in_parts(std::vector<Edge> waiting) {
  std::vector<Edge> made;
  waiting.reserve(kRoom * waiting.size());
  made.reserve(kRoom * waiting.size());
  for (const size_t most = max_flips(); !waiting.empty() && made.size() < most;) {
    flip_last(waiting, made);
    co_await yield_after(1);
  }
  co_return made;
}

Task<Done> WallMesh::improve() {
  co_await flip_in_parts(inner_edges());
  co_return Done{};
}

ChartVertex WallMesh::middle_of(const Quad& q) const {
  const int64_t ya = vertices_[q.a].chart.y, yb = vertices_[q.b].chart.y;
  return within({q.xa + (q.xb - q.xa) / 2, ya + (yb - ya) / 2});
}

void WallMesh::split(const Quad& q, const Vec3& at) {
  const ChartVertex place = middle_of(q);
  const int64_t xm = q.xa + (q.xb - q.xa) / 2;
  const auto m = static_cast<uint32_t>(vertices_.size());
  const auto third = static_cast<uint32_t>(triangles_.size()), fourth = third + 1;
  vertices_.push_back({at, place});
  is_pinched_.push_back(false);
  triangles_.resize(fourth + 1);
  x_.resize(fourth + 1);
  across_.resize(fourth + 1);
  known_.resize(fourth + 1, kUnknown);
  set(q.left, {{q.a, m, q.c}, {q.xa, xm, q.xc}}, {fourth, third, q.beyond[1]}, {-1, -1, q.known[1]});
  set(third, {{m, q.b, q.c}, {xm, q.xb, q.xc}}, {q.right, q.beyond[0], q.left}, {-1, q.known[0], -1});
  set(q.right, {{q.b, m, q.d}, {q.xb, xm, q.xd}}, {third, fourth, q.beyond[3]}, {-1, -1, q.known[3]});
  set(fourth, {{m, q.a, q.d}, {xm, q.xa, q.xd}}, {q.left, q.beyond[2], q.right}, {-1, q.known[2], -1});
  for (const uint32_t t : {q.left, third, q.right, fourth}) is_folded_ = is_folded_ || !is_upright(t);
}

// Returns true if a point is much nearer to one end of the edge between the triangles than to the other.
bool WallMesh::is_beside_an_end(const Quad& q, const Vec3& p) const {
  const Vec3 a = vertices_[q.a].at, b = vertices_[q.b].at;
  return std::min(glm::length(p - a), glm::length(p - b)) < kBesideEnd * glm::length(b - a);
}

Task<Done> WallMesh::refine(const Middle& middle) {
  std::vector<Edge> waiting = inner_edges();
  while (!waiting.empty()) {
    std::vector<Edge> next, around;
    for (const Edge& e : waiting) {
      co_await yield_after(1);
      if (!is_current(e) || !is_inner(e)) continue;
      const Quad q = quad_of(e);
      if (!(excess(q) > 0)) continue;
      const auto at = middle(middle_of(q));
      // The chart may map a whole edge to almost a point.
      if (!at || is_beside_an_end(q, *at)) continue;
      split(q, *at);
      const auto first = static_cast<uint32_t>(triangles_.size()) - 2;
      for (const uint32_t t : {q.left, q.right, first, first + 1}) {
        for (uint32_t i = 0; i < 3; ++i) next.push_back(edge(t, i));
      }
      for (const Edge& side : {edge(q.left, 2), edge(q.right, 2), edge(first, 1), edge(first + 1, 1)})
        around.push_back(side);
    }
    const std::vector<Edge> turned = co_await flip_in_parts(std::move(around));
    next.insert(next.end(), turned.begin(), turned.end());
    waiting = std::move(next);
  }
  co_return Done{};
}

std::optional<uint32_t> WallMesh::edge_below(double length) const {
  KERF_ASSERT(length > 0);
  for (uint32_t t = 0; t < triangles_.size(); ++t) {
    for (uint32_t i = 0; i < 3; ++i) {
      const Vec3 way = vertices_[triangles_[t][(i + 1) % 3]].at - vertices_[triangles_[t][i]].at;
      if (across_[t][i] != kNone && t < across_[t][i] && glm::length(way) < length) return triangles_[t][i];
    }
  }
  return std::nullopt;
}

Task<Done> WallMesh::split_between(uint32_t fixed, const std::function<bool(uint32_t, uint32_t)>& splits,
                                   const Middle& middle) {
  bool again = true;
  while (std::exchange(again, false)) {
    const std::vector<Edge> edges = inner_edges();
    for (const Edge& e : edges) {
      co_await yield_after(1);
      if (e.from >= fixed || e.to >= fixed || !splits(e.from, e.to)) continue;
      // A split moves other edges of its two triangles.
      again = !is_current(e) || again;
      if (!is_current(e)) continue;
      const Quad q = quad_of(e);
      if (const auto at = middle(middle_of(q))) split(q, *at);
    }
  }
  co_return Done{};
}

Task<std::optional<WallMesh>> triangulate_cap(std::span<const Vec2> places, std::span<const Vec3> at,
                                              std::span<const std::pair<uint32_t, uint32_t>> sides,
                                              double least, const std::function<Vec3(Vec2)>& lift,
                                              uint32_t& conflict) {
  KERF_ASSERT(!sides.empty() && places.size() == at.size());
  constexpr int64_t kSize = int64_t{1} << 30, kWidth = 4 * kSize;
  Vec2 low = places[0], high = places[0];
  for (const Vec2 p : places) {
    low = glm::min(low, p);
    high = glm::max(high, p);
  }
  const double scale = static_cast<double>(kSize - 2) / std::max(high.x - low.x, high.y - low.y);
  const auto whole = [&](double x) { return static_cast<int64_t>(x * scale + 0.5); };
  std::vector<ChartVertex> placed;
  for (const Vec2 p : places) placed.push_back({whole(p.x - low.x), whole(p.y - low.y)});
  std::vector<ChartEdge> edges;
  for (const auto& [from, to] : sides) edges.push_back({from, to, placed[to].x - placed[from].x});
  std::vector<uint32_t> conflicts;
  const auto triangles = co_await ChartRegion(placed, edges, kWidth).triangles(&conflicts);
  if (!triangles) {
    conflict = conflicts.empty() ? 0 : conflicts.front();
    co_return std::nullopt;
  }
  std::vector<WallMesh::Vertex> vertices;
  for (size_t i = 0; i < placed.size(); ++i) vertices.push_back({at[i], placed[i]});
  WallMesh cap(
      std::move(vertices), *triangles, kWidth,
      [](const WallMesh::Vertex&, const WallMesh::Vertex&) { return 0.0; }, 0);
  co_await cap.improve();
  const WallMesh::Middle lifted = [&](const ChartVertex& v) {
    return std::optional(lift(low + Vec2(static_cast<double>(v.x), static_cast<double>(v.y)) / scale));
  };
  co_await cap.grade(least, lifted);
  co_return cap;
}

}  // namespace kerf
