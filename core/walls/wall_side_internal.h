#pragma once

#include <array>
#include <functional>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "core/base/geometry.h"
#include "core/walls/chart_region_internal.h"
#include "core/walls/wall_chart_internal.h"

namespace kerf {

// The chart of one curve of the outline in whole numbers: x goes around, y against the depth. The beam is on
// the left of the outline, so that walls whose outside faces the beam are counter-clockwise.
class SideChart {
 public:
  static constexpr int64_t kSize = int64_t{1} << 30;  // the width of the chart; y is less

  // The chart for depths within `depths` (m). Precondition: `chart` outlives this.
  SideChart(const WallChart& chart, uint32_t curve, Interval depths);

  ChartVertex place(double around, double depth) const;
  Vec3 point(const ChartVertex& v) const;

  // By how much x grows along an edge of the rim, which goes the shorter way around the beam.
  static int64_t x_between(const ChartVertex& from, const ChartVertex& to);
  // The vertex in the middle of an edge, the x of whose ends may lie beyond the width.
  static ChartVertex middle(const ChartVertex& from, const ChartVertex& to);

 private:
  // Beams through an apex see straight lines as such where depth is measured by its reciprocal.
  double height(double depth) const { return chart_->parallel() ? -depth : 1 / depth; }
  double depth(double height) const { return chart_->parallel() ? -height : 1 / height; }

  const WallChart* chart_;
  uint32_t curve_;
  double lowest_ = 0, scale_ = 1;  // of heights
};

// The edges of a rim in its chart.
struct RimInChart {
  std::span<const ChartVertex> placed;  // vertices
  std::span<const Vec3> at;             // the same, m
  std::vector<ChartEdge> edges;
  int64_t width = 0;  // of the chart
};

// The windings of the edges around the points of the chart. A rim may be off the boundary by a little, and
// its edges are chords: where some cross or touch, triangles no higher than `highest` (m) are cut off at
// vertices there, the smallest first, which become faces of the wall and are appended to `cut_off`. No third
// side of such a triangle runs between vertices for which `are_joined` holds. Returns nothing where that does
// not help; `conflict` then holds vertices of edges that cross or touch. O(n log n) for each triangle that is
// cut off.
Resumable<std::optional<ChartRegion::Winding>> untangle(
    RimInChart& rim, double highest, const std::function<bool(uint32_t, uint32_t)>& are_joined,
    std::vector<std::array<uint32_t, 3>>& cut_off, std::vector<uint32_t>& conflict);

// What a rim does on one side of the beam, i.e. around one curve of its outline: vertices at places, and
// directed edges in the chart with the wall on their left. Where the rim does not bound the wall, because the
// range of the beam ends in the solid, further edges close it along the end, and a cap begins beyond them.
class WallSide {
 public:
  // Precondition: `chart` outlives this.
  WallSide(const WallChart& chart, uint32_t curve, Interval depths)
      : chart_(&chart), curve_(curve), side_chart_(chart, curve, depths) {}

  // Adds a vertex of the rim, and returns its number. Precondition: the place is around the curve.
  uint32_t add_vertex(const WallChart::Place& place);
  // Adds an edge of the rim, which goes the shorter way around.
  void add_edge(uint32_t from, uint32_t to);
  // Puts all vertices into a chart for depths within `depths` (m).
  void place_within(Interval depths);

  // Close the side along an end of the range at a depth: all around; or between vertices there at which the
  // rim leaves the side and comes back to it. The latter returns whether there are any, and nothing where
  // they do not match, of which `conflict` then is one.
  void close_all_around(double depth, bool is_high);
  std::optional<bool> close_between_corners(double depth, bool is_high, uint32_t& conflict);

  const SideChart& side_chart() const { return side_chart_; }
  std::span<const WallChart::Place> places() const { return places_; }  // of the vertices
  std::span<const ChartVertex> placed() const { return placed_; }       // the same in the chart
  std::vector<ChartEdge>& edges() { return edges_; }
  const std::vector<ChartEdge>& edges() const { return edges_; }
  // The sides of the cap at an end, as pairs of vertices.
  std::span<const std::pair<uint32_t, uint32_t>> cap(bool is_high) const { return caps_[is_high ? 1 : 0]; }

 private:
  // A corner at which the rim leaves the side (+1) or comes back to it (-1), or a place between corners (0).
  struct Stop {
    int64_t x;
    int balance;
    uint32_t vertex;
    double around;
  };
  std::optional<std::vector<Stop>> corners_at(double depth, uint32_t& conflict) const;
  void append_between(double depth, std::vector<Stop>& stops) const;
  void add_end_edge(uint32_t from, uint32_t to, bool is_high);

  const WallChart* chart_;
  uint32_t curve_;
  SideChart side_chart_;
  std::vector<WallChart::Place> places_;
  std::vector<ChartVertex> placed_;
  std::vector<ChartEdge> edges_;
  std::vector<std::pair<uint32_t, uint32_t>> caps_[2];
};

}  // namespace kerf
