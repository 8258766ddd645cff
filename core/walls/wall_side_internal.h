#pragma once

#include <array>
#include <functional>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "core/base/geometry.h"
#include "core/base/result.h"
#include "core/base/task.h"
#include "core/walls/chart_region_internal.h"
#include "core/walls/make_walls.h"
#include "core/walls/wall_chart_internal.h"

namespace kerf {

// The boundary of the swept volume, in the range of depths of a rim.
struct SweptSides {
  BeamPencil pencil;
  RangeEnds ends;
  Interval depths;  // of the rim, m
  WallChart chart;
  double reach = 0;  // max distance of a vertex of the rim from the chart [m]
};

// Computes the chart of the swept volume for the vertices of a rim. Fails with a reason if the beam has no
// chart. Precondition: `vertices` is not empty.
Task<Result<SweptSides>> swept_sides(const Mesh& mesh, std::span<const VertexId> vertices,
                                     const WallStroke& stroke);

// Returns the vertices of sides, ascending.
std::vector<VertexId> vertices_of(std::span<const RimSide> sides);

// Groups the sides of the rim by solid, each group in the order of `sides`: the parts of an outer shell and
// of its cavities, which bound its walls together. A rim that runs clockwise in the chart belongs to a
// cavity, which is part of the same solid as the nearest rim below it. `part_of_face` holds the index of the
// connected part of each face, at least for the faces of all sides. O(n log n) without cavities, plus O(n)
// for each of their rims.
Task<std::vector<std::vector<RimSide>>> group_rims(const Mesh& mesh, std::span<const RimSide> sides,
                                                   std::span<const uint32_t> part_of_face,
                                                   const WallStroke& stroke, const SweptSides& swept);

// Chart of one curve of the outline, with integer coordinates: x runs around the beam, y against the depth.
// The beam is on the left of the outline, so that walls whose outside faces the beam are counter-clockwise.
class SideChart {
 public:
  static constexpr int64_t kSize = int64_t{1} << 30;  // width of the chart; y is less

  // Chart for depths within `depths` (m). Precondition: `chart` outlives this.
  SideChart(const WallChart& chart, uint32_t curve, Interval depths);

  ChartVertex place(double around, double depth) const;
  Vec3 point(const ChartVertex& v) const;

  // Returns the increase of x along an edge of the rim; the edge runs the shorter way around the beam.
  static int64_t x_between(const ChartVertex& from, const ChartVertex& to);
  // Returns the midpoint of an edge. The x of either end may lie outside the width of the chart.
  static ChartVertex middle(const ChartVertex& from, const ChartVertex& to);

 private:
  // If the axes of the beam meet in an apex, straight lines are straight in the chart only if y is linear in
  // the reciprocal of the depth.
  double height(double depth) const { return chart_->has_apex() ? 1 / depth : -depth; }
  double depth(double height) const { return chart_->has_apex() ? 1 / height : -height; }

  const WallChart* chart_;
  uint32_t curve_;
  double lowest_ = 0, scale_ = 1;  // of heights
};

// Edges of a rim in its chart.
struct RimInChart {
  std::span<const ChartVertex> placed;  // vertices
  std::span<const Vec3> at;             // the same, in space [m]
  std::vector<ChartEdge> edges;
  int64_t width = 0;  // of the chart
};

// Returns the winding numbers of the edges around the points of the chart. Vertices of a rim may be slightly
// off the boundary, and its edges are chords: if some cross or touch, triangles at their vertices with a
// height of at most `highest` (m) are cut off, smallest first; they become faces of the wall and are appended
// to `cut_off`. The third side of such a triangle never joins vertices for which `are_joined` holds. Returns
// nullopt if that does not resolve all crossings; `conflict` then holds vertices of edges that cross or
// touch. O(n log n) per triangle cut off.
Task<std::optional<ChartRegion::Winding>> untangle(RimInChart& rim, double highest,
                                                   const std::function<bool(uint32_t, uint32_t)>& are_joined,
                                                   std::vector<std::array<uint32_t, 3>>& cut_off,
                                                   std::vector<uint32_t>& conflict);

// The rim on one side of the beam, i.e. around one curve of its outline: vertices at places, and directed
// edges in the chart with the wall on their left. If the range of the beam ends in the solid, so that the
// rim does not bound the wall there, further edges close it along the end, and a cap begins beyond them.
class WallSide {
 public:
  // Precondition: `chart` outlives this.
  WallSide(const WallChart& chart, uint32_t curve, Interval depths)
      : chart_(&chart), curve_(curve), side_chart_(chart, curve, depths) {}

  // Adds a vertex of the rim and returns its index. Precondition: the place is around the curve.
  uint32_t add_vertex(const WallChart::Place& place);
  // Adds an edge of the rim, which runs the shorter way around.
  void add_edge(uint32_t from, uint32_t to);
  // Places all vertices in a chart for depths within `depths` (m).
  void place_within(Interval depths);

  // Close the side along an end of the range at a depth: all around, or between corners, i.e. vertices at
  // which the rim leaves the side and returns to it. The latter returns true if there are corners, and
  // nullopt if they do not match; `conflict` is then one of them.
  void close_all_around(double depth, bool is_high);
  std::optional<bool> close_between_corners(double depth, bool is_high, uint32_t& conflict);

  const SideChart& side_chart() const { return side_chart_; }
  std::span<const WallChart::Place> places() const { return places_; }  // of the vertices
  std::span<const ChartVertex> placed() const { return placed_; }       // the same in the chart
  std::vector<ChartEdge>& edges() { return edges_; }
  const std::vector<ChartEdge>& edges() const { return edges_; }
  // Returns the sides of the cap at an end, as pairs of vertices.
  std::span<const std::pair<uint32_t, uint32_t>> cap(bool is_high) const { return caps_[is_high ? 1 : 0]; }

 private:
  // A corner at which the rim leaves the side (+1) or returns to it (-1), or a place between corners (0).
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
