#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <locale>
#include <map>
#include <sstream>

#include "core/base/assert.h"
#include "core/base/containers.h"
#include "core/mesh/mesh.h"
#include "core/walls/wall_side_internal.h"

namespace kerf {

namespace {

// Max distance of a vertex of the rim from the outline, in radii: the permitted errors of the rim. For
// beams through an apex this increases by the excess of an inclined beam's ellipse over a circle, and by
// its growth up to the next depth with an outline; at least kMinOfFan in all.
constexpr double kReach = 0.03, kReachOfFan = 0.1, kMinOfFan = 0.3;

Interval depths_of(const BeamPencil& pencil, const Mesh& mesh, std::span<const VertexId> vertices) {
  Interval depths{pencil.see(mesh.position(vertices[0])).depth, pencil.see(mesh.position(vertices[0])).depth};
  for (const VertexId v : vertices.subspan(1)) {
    const double depth = pencil.see(mesh.position(v)).depth;
    depths = {std::min(depths.low, depth), std::max(depths.high, depth)};
  }
  return depths;
}

constexpr uint32_t kNowhere = 0xffffffffu;
// Edges this near to each other in the chart coincide, except for its rounding.
constexpr double kOneUnit = 1;

// A side of a wall along the rim, in the chart of a curve of the outline or of an end (a further curve).
struct ChartSide {
  uint32_t from = 0, to = 0;  // vertices
  uint32_t part = 0;
  uint32_t curve = kNowhere;
  double x = 0, y = 0;    // of `from`
  double dx = 0, dy = 0;  // to `to`
};

class RimGrouping {
 public:
  RimGrouping(const Mesh& mesh, std::span<const RimSide> sides, std::span<const uint32_t> part_of_face,
              const WallStroke& stroke, const SweptSides& swept)
      : mesh_(mesh),
        rim_(sides),
        part_of_face_(part_of_face),
        stroke_(stroke),
        swept_(swept),
        vertices_(vertices_of(sides)) {}

  Task<Done> run() {
    co_await place_sides();
    uint32_t parts = 0;
    for (const ChartSide& s : sides_) parts = std::max(parts, s.part + 1);
    together_.emplace(parts);
    co_await walk_loops();
    co_await yield_after(rim_.size());
    co_return Done{};
  }

  // Precondition: the grouping was run.
  std::vector<std::vector<RimSide>> take_groups() {
    KERF_ASSERT(together_ && sides_.size() == rim_.size());
    std::vector<std::vector<RimSide>> groups;
    std::map<uint32_t, size_t> number;
    for (size_t i = 0; i < rim_.size(); ++i) {
      const auto [at, is_new] = number.try_emplace(together_->find(sides_[i].part), groups.size());
      if (is_new) groups.emplace_back();
      groups[at->second].push_back(rim_[i]);
    }
    return groups;
  }

 private:
  uint32_t low_end() const { return static_cast<uint32_t>(swept_.chart.curves()); }

  Task<Done> place_sides() {
    std::vector<NearBoundary> near;
    for (const VertexId v : vertices_) {
      const Vec3 p = mesh_.position(v);
      near.push_back(near_boundary(swept_.chart, swept_.ends, p, swept_.pencil.see(p).depth, swept_.reach));
      co_await yield_after(2);
    }
    const auto index = [&](VertexId v) {
      return static_cast<uint32_t>(std::lower_bound(vertices_.begin(), vertices_.end(), v) -
                                   vertices_.begin());
    };
    for (const RimSide& s : rim_) {
      ChartSide side;
      side.from = index(s.to);
      side.to = index(s.from);
      KERF_ASSERT(s.face.index < part_of_face_.size());
      side.part = part_of_face_[s.face.index];
      KERF_ASSERT(side.part != kNoPart);
      place(side, near[side.from], near[side.to]);
      sides_.push_back(side);
      co_await yield_after(1);
    }
    co_return Done{};
  }

  void place(ChartSide& side, const NearBoundary& from, const NearBoundary& to) const {
    const auto part = part_along(from, to);
    if (!part) return;
    if (*part == BoundaryPart::kSide) {
      if (!from.place || !to.place || from.place->curve != to.place->curve) return;
      side.curve = from.place->curve;
      const SideChart chart(swept_.chart, side.curve, swept_.depths);
      const ChartVertex a = chart.place(from.place->around, from.place->depth),
                        b = chart.place(to.place->around, to.place->depth);
      side.x = static_cast<double>(a.x);
      side.y = static_cast<double>(a.y);
      side.dx = static_cast<double>(SideChart::x_between(a, b));
      side.dy = static_cast<double>(b.y - a.y);
      return;
    }
    const bool is_high = *part == BoundaryPart::kHighEnd;
    side.curve = low_end() + is_high;
    Vec2 a = swept_.pencil.see(mesh_.position(vertices_[side.from])).place,
         b = swept_.pencil.see(mesh_.position(vertices_[side.to])).place;
    if (is_high) {
      a.y = -a.y;
      b.y = -b.y;
    }
    side.x = a.x;
    side.y = a.y;
    side.dx = b.x - a.x;
    side.dy = b.y - a.y;
  }

  Task<Done> walk_loops() {
    std::vector<std::vector<uint32_t>> starting(vertices_.size());
    for (uint32_t i = 0; i < sides_.size(); ++i) starting[sides_[i].from].push_back(i);
    std::vector<bool> walked(sides_.size());
    std::vector<uint32_t> loop;
    for (uint32_t first = 0; first < sides_.size(); ++first) {
      if (walked[first]) continue;
      loop.clear();
      for (uint32_t at = first;;) {
        walked[at] = true;
        loop.push_back(at);
        const auto& next = starting[sides_[at].to];
        const auto free = std::find_if(next.begin(), next.end(), [&](uint32_t s) { return !walked[s]; });
        if (sides_[at].to == sides_[first].from || free == next.end()) break;
        at = *free;
      }
      co_await yield_after(loop.size());
      if (!is_clockwise(loop)) continue;
      join_to_solid(loop);
      co_await yield_after(sides_[first].curve < low_end() ? sides_.size() / 4 : 64);
    }
    co_return Done{};
  }

  // Returns true if a loop lies in one chart and bounds the region outside it.
  bool is_clockwise(std::span<const uint32_t> loop) const {
    const uint32_t curve = sides_[loop[0]].curve;
    if (curve == kNowhere || sides_[loop.back()].to != sides_[loop[0]].from) return false;
    double x = 0, y = 0, area = 0;
    for (const uint32_t i : loop) {
      const ChartSide& s = sides_[i];
      if (s.curve != curve) return false;
      area += x * s.dy - y * s.dx;
      x += s.dx;
      y += s.dy;
    }
    return area < 0 && std::abs(x) < static_cast<double>(SideChart::kSize) / 2;
  }

  void join_to_solid(std::span<const uint32_t> loop) {
    const uint32_t own = sides_[loop[0]].part;
    if (sides_[loop[0]].curve >= low_end()) return join_to_solid_around(loop[0]);
    std::vector<uint32_t> sorted(loop.begin(), loop.end());
    std::sort(sorted.begin(), sorted.end());
    for (const double up : {-1.0, 1.0}) {
      const auto nearest = nearest_side(sorted, up);
      if (!nearest) continue;
      together_->unite(own, sides_[*nearest].part);
      return;
    }
  }

  // Returns the nearest side of another loop below the lowest vertex of a loop (up = -1) or above the
  // highest one, if its wall is on the side of the loop.
  std::optional<uint32_t> nearest_side(std::span<const uint32_t> loop, double up) const {
    const ChartSide& start = sides_[*std::max_element(loop.begin(), loop.end(), [&](uint32_t a, uint32_t b) {
      return up * sides_[a].y < up * sides_[b].y;
    })];
    const double width = static_cast<double>(SideChart::kSize);
    std::optional<uint32_t> nearest;
    double least = 0;
    for (uint32_t i = 0; i < sides_.size(); ++i) {
      const ChartSide& s = sides_[i];
      if (s.curve != start.curve || s.dx == 0 || std::binary_search(loop.begin(), loop.end(), i)) continue;
      double along = (start.x - s.x) * (s.dx > 0 ? 1 : -1);
      along -= width * std::floor(along / width);
      if (along >= std::abs(s.dx)) continue;
      const double away = up * (s.y + s.dy * along / std::abs(s.dx) - start.y);
      if (away < -kOneUnit) continue;
      const bool is_as_near = nearest && std::abs(away - least) <= kOneUnit;
      const bool faces_loop = s.dx * up < 0;
      if (nearest && !(is_as_near ? faces_loop : away < least)) continue;
      nearest = i;
      least = away;
    }
    if (nearest && sides_[*nearest].dx * up < 0) return nearest;
    return std::nullopt;
  }

  // Joins a loop in the plane of an end to the parts that wind around its vertices, seen away from the beam.
  void join_to_solid_around(uint32_t side) {
    const ChartSide& s = sides_[side];
    const double sign = s.curve > low_end() ? 1 : -1;
    std::map<uint32_t, int> winding;
    for (const auto& [face, sense] :
         stroke_.crossings(mesh_.position(vertices_[s.from]), sign * swept_.pencil.axis())) {
      if (face.index < part_of_face_.size()) winding[part_of_face_[face.index]] += sense;
    }
    for (const ChartSide& other : sides_) {
      if (other.part == s.part) continue;
      const auto at = winding.find(other.part);
      if (at != winding.end() && at->second > 0) together_->unite(s.part, other.part);
    }
  }

  const Mesh& mesh_;
  std::span<const RimSide> rim_;
  std::span<const uint32_t> part_of_face_;
  const WallStroke& stroke_;
  const SweptSides& swept_;
  std::vector<VertexId> vertices_;
  std::vector<ChartSide> sides_;  // in the order of rim_
  std::optional<UnionFind> together_;
};

constexpr int kMaxCuts = 256;

// Edges before and after a vertex that the rim passes once.
struct Passage {
  size_t in, out;
};

std::optional<Passage> passage(const std::vector<ChartEdge>& edges, uint32_t v) {
  std::optional<size_t> in, out;
  for (size_t i = 0; i < edges.size(); ++i) {
    for (const auto& [end, edge] : {std::pair(edges[i].to, &in), std::pair(edges[i].from, &out)}) {
      if (end != v) continue;
      if (*edge) return std::nullopt;
      *edge = i;
    }
  }
  if (!in || !out) return std::nullopt;
  return Passage{*in, *out};
}

// Returns the edge from the end of a passage to its start, which closes a triangle of the three.
std::optional<size_t> closing_edge(const std::vector<ChartEdge>& edges, const Passage& p) {
  for (size_t i = 0; i < edges.size(); ++i) {
    if (edges[i].from == edges[p.out].to && edges[i].to == edges[p.in].from) return i;
  }
  return std::nullopt;
}

void cut(std::vector<ChartEdge>& edges, const Passage& p) {
  KERF_ASSERT(p.in != p.out && std::max(p.in, p.out) < edges.size());
  std::vector<size_t> removed{p.out};
  if (const auto third = closing_edge(edges, p)) {
    removed.insert(removed.end(), {p.in, *third});
  } else {
    edges[p.in].dx += edges[p.out].dx;
    edges[p.in].to = edges[p.out].to;
  }
  std::sort(removed.begin(), removed.end());
  for (size_t i = removed.size(); i-- > 0;)
    edges.erase(edges.begin() + static_cast<std::ptrdiff_t>(removed[i]));
}

// Angle of a chord between corners of a wall's end, from the arc's centre: it deviates by kRimChord.
constexpr double kTurnOfEnd = 0.0979;

}  // namespace

Error left_open(const char* why, const Vec3& p) {
  std::ostringstream text;
  text.imbue(std::locale::classic());
  text.precision(3);
  text << why << " near (" << p.x << ", " << p.y << ", " << p.z << ")";
  return failed(text.str());
}

std::vector<VertexId> vertices_of(std::span<const RimSide> sides) {
  std::vector<VertexId> vertices;
  for (const RimSide& s : sides) {
    vertices.push_back(s.from);
    vertices.push_back(s.to);
  }
  std::sort(vertices.begin(), vertices.end());
  vertices.erase(std::unique(vertices.begin(), vertices.end()), vertices.end());
  return vertices;
}

Task<Result<SweptSides>> swept_sides(const Mesh& mesh, std::span<const VertexId> vertices,
                                     const WallStroke& stroke) {
  KERF_ASSERT(!vertices.empty());
  const Vec3 first = mesh.position(vertices[0]);
  const char* why = "the beam turns by more than 72 degrees from its middle direction";
  for (const BeamPencil& pencil : BeamPencil::all_of(stroke.moves, stroke.radius)) {
    const Interval depths = depths_of(pencil, mesh, vertices);
    auto chart = co_await WallChart::make(pencil, stroke.moves, stroke.radius, depths, stroke.range);
    if (!chart) {
      why = "the outline of the swept beam differs too much between depths of the part";
      continue;
    }
    const double longer = pencil.longest_ellipse(stroke.moves, depths.high) - 1;
    const double reach =
        stroke.radius * (pencil.parallel() ? kReach : std::max(kReachOfFan + 1.2 * longer, kMinOfFan));
    co_return SweptSides{pencil, range_ends(pencil, stroke.moves, stroke.range, stroke.radius), depths,
                         std::move(*chart), reach};
  }
  co_return left_open(why, first);
}

Task<std::vector<std::vector<RimSide>>> group_rims(const Mesh& mesh, std::span<const RimSide> sides,
                                                   std::span<const uint32_t> part_of_face,
                                                   const WallStroke& stroke, const SweptSides& swept) {
  RimGrouping grouping(mesh, sides, part_of_face, stroke, swept);
  co_await grouping.run();
  co_return grouping.take_groups();
}

SideChart::SideChart(const WallChart& chart, uint32_t curve, Interval depths)
    : chart_(&chart), curve_(curve) {
  KERF_ASSERT(curve < chart.curves() && depths.low <= depths.high);
  const auto [low, high] = std::minmax({height(depths.low), height(depths.high)});
  lowest_ = low;
  if (high > low) scale_ = static_cast<double>(kSize - 2) / (high - low);
}

ChartVertex SideChart::place(double around, double depth) const {
  const double share = around / chart_->period(curve_);
  return {std::min(static_cast<int64_t>(share * static_cast<double>(kSize)), kSize - 1),
          static_cast<int64_t>((height(depth) - lowest_) * scale_ + 0.5)};
}

Vec3 SideChart::point(const ChartVertex& v) const {
  const double around = static_cast<double>(v.x) / static_cast<double>(kSize) * chart_->period(curve_);
  return chart_->point_at({curve_, around, depth(lowest_ + static_cast<double>(v.y) / scale_)});
}

int64_t SideChart::x_between(const ChartVertex& from, const ChartVertex& to) {
  const int64_t way = to.x - from.x;
  if (way > kSize / 2) return way - kSize;
  return way < -kSize / 2 ? way + kSize : way;
}

ChartVertex SideChart::middle(const ChartVertex& from, const ChartVertex& to) {
  const int64_t x = (from.x + to.x) / 2;
  return {(x % kSize + kSize) % kSize, (from.y + to.y) / 2};
}

Task<std::optional<ChartRegion::Winding>> untangle(RimInChart& rim, double highest,
                                                   const std::function<bool(uint32_t, uint32_t)>& are_joined,
                                                   std::vector<std::array<uint32_t, 3>>& cut_off,
                                                   std::vector<uint32_t>& conflict) {
  KERF_ASSERT(rim.placed.size() == rim.at.size() && highest >= 0);
  for (int i = 0; i < kMaxCuts; ++i) {
    const auto winding = co_await ChartRegion(rim.placed, rim.edges, rim.width).winding(&conflict);
    if (winding) co_return winding;
    std::optional<Passage> best;
    double least = std::numeric_limits<double>::infinity();
    for (const uint32_t v : conflict) {
      const auto p = passage(rim.edges, v);
      if (!p) continue;
      const uint32_t a = rim.edges[p->in].from, c = rim.edges[p->out].to;
      if (a == c) continue;
      const Triangle t{rim.at[a], rim.at[v], rim.at[c]};
      const double area = triangle_area(t), height = 2 * area / std::sqrt(longest_edge2(t));
      if (!(height <= highest) || !(area < least)) continue;
      if (are_joined(a, c) && !closing_edge(rim.edges, *p)) continue;
      best = p;
      least = area;
    }
    if (!best) co_return std::nullopt;
    cut_off.push_back({rim.edges[best->in].from, rim.edges[best->in].to, rim.edges[best->out].to});
    cut(rim.edges, *best);
  }
  co_return std::nullopt;
}

uint32_t WallSide::add_vertex(const WallChart::Place& place) {
  KERF_ASSERT(place.curve == curve_);
  places_.push_back(place);
  placed_.push_back(side_chart_.place(place.around, place.depth));
  return static_cast<uint32_t>(placed_.size() - 1);
}

void WallSide::add_edge(uint32_t from, uint32_t to) {
  KERF_ASSERT(std::max(from, to) < placed_.size());
  edges_.push_back({from, to, SideChart::x_between(placed_[from], placed_[to])});
}

void WallSide::place_within(Interval depths) {
  side_chart_ = SideChart(*chart_, curve_, depths);
  for (size_t i = 0; i < places_.size(); ++i)
    placed_[i] = side_chart_.place(places_[i].around, places_[i].depth);
}

// Adds an edge along an end, and the side of the cap beyond it. The wall lies on the left.
void WallSide::add_end_edge(uint32_t from, uint32_t to, bool is_high) {
  int64_t dx = placed_[to].x - placed_[from].x;
  if (is_high && dx <= 0) dx += SideChart::kSize;
  if (!is_high && dx >= 0) dx -= SideChart::kSize;
  edges_.push_back({from, to, dx});
  caps_[is_high ? 1 : 0].emplace_back(to, from);
}

void WallSide::close_all_around(double depth, bool is_high) {
  std::vector<uint32_t> ring;
  for (const double around : chart_->corners(curve_, kTurnOfEnd))
    ring.push_back(add_vertex({curve_, around, depth}));
  KERF_ASSERT(!ring.empty());
  if (!is_high) std::reverse(ring.begin(), ring.end());
  for (size_t i = 0; i < ring.size(); ++i) add_end_edge(ring[i], ring[(i + 1) % ring.size()], is_high);
}

// Returns nullopt if the rim leaves the side or returns to it twice at one vertex.
std::optional<std::vector<WallSide::Stop>> WallSide::corners_at(double depth, uint32_t& conflict) const {
  std::vector<int> balance(placed_.size());
  for (const ChartEdge& e : edges_) {
    ++balance[e.to];
    --balance[e.from];
  }
  std::vector<Stop> corners;
  for (uint32_t v = 0; v < balance.size(); ++v) {
    if (balance[v] == 0 || places_[v].depth != depth) continue;
    conflict = v;
    if (std::abs(balance[v]) != 1) return std::nullopt;
    corners.push_back({placed_[v].x, balance[v], v, 0});
  }
  return corners;
}

// Appends the places between corners at which an end has further vertices.
void WallSide::append_between(double depth, std::vector<Stop>& stops) const {
  const std::vector<Stop> corners = stops;
  for (const double around : chart_->corners(curve_, kTurnOfEnd)) {
    const int64_t x = side_chart_.place(around, depth).x;
    const bool is_taken =
        std::any_of(corners.begin(), corners.end(), [&](const Stop& corner) { return corner.x == x; });
    if (!is_taken) stops.push_back({x, 0, 0, around});
  }
}

std::optional<bool> WallSide::close_between_corners(double depth, bool is_high, uint32_t& conflict) {
  std::optional<std::vector<Stop>> found = corners_at(depth, conflict);
  if (!found) return std::nullopt;
  std::vector<Stop>& ring = *found;
  if (ring.empty()) return false;
  append_between(depth, ring);
  std::sort(ring.begin(), ring.end(), [](const Stop& a, const Stop& b) { return a.x < b.x; });
  if (!is_high) std::reverse(ring.begin(), ring.end());
  int open = 0;
  for (size_t i = 0; i < ring.size(); ++i) {
    open += ring[i].balance;
    if (ring[i].balance != 1) continue;
    uint32_t from = ring[i].vertex;
    for (size_t k = (i + 1) % ring.size();; k = (k + 1) % ring.size()) {
      const Stop& stop = ring[k];
      if (stop.balance > 0) {
        conflict = stop.vertex;
        return std::nullopt;
      }
      const uint32_t to = stop.balance < 0 ? stop.vertex : add_vertex({curve_, stop.around, depth});
      add_end_edge(from, to, is_high);
      if (stop.balance < 0) break;
      from = to;
    }
  }
  if (open != 0) return std::nullopt;
  return true;
}

}  // namespace kerf
