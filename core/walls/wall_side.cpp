#include "core/walls/wall_side.h"

#include <algorithm>
#include <cstdlib>

#include "core/base/assert.h"

namespace kerf {

namespace {

// Two corners of the end of a wall, as seen from the middle of an arc: their chord lies kRimChord from it.
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

// Nothing where the rim leaves the side or comes back to it twice at one vertex.
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
