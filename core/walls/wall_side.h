#pragma once

#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "core/base/interval.h"
#include "core/walls/chart_region.h"
#include "core/walls/side_chart.h"
#include "core/walls/wall_chart.h"

namespace kerf {

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
