#include "core/walls/wall_side_internal.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>

#include "core/base/assert.h"
#include "core/mesh/mesh.h"

namespace kerf {

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

namespace {

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

}  // namespace

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

namespace {

// Angle of a chord between corners of a wall's end, from the arc's centre: it deviates by kRimChord.
constexpr double kTurnOfEnd = 0.0979;

}  // namespace

uint32_t WallSide::add_vertex(const WallChart::Place& place) {
  KERF_ASSERT(place.curve == curve_);
  places_.push_back(place);
  placed_.push_back(side_chart_.place(place.around, place.depth));
  return static_cast<uint32_t>(placed_.size() - 1);
}

void WallSide::add_edge(uint32_t from, uint32_t to) {
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
