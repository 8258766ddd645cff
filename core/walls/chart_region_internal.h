#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "core/base/task.h"

namespace kerf {

__extension__ using Wide = __int128;

// A vertex in the chart of a wall. Coordinates are integers below 2^30, so that orientations are exact.
struct ChartVertex {
  int64_t x = 0, y = 0;
};

// An edge of the boundary of a region; the region lies on its left. `dx` is the increase of x along the edge:
// on a strip closed to a ring, the ends alone do not determine in which direction the edge runs around.
struct ChartEdge {
  uint32_t from = 0, to = 0;
  int64_t dx = 0;
};

// A counter-clockwise triangle; the x of its corners may lie beyond the width of the strip.
struct ChartTriangle {
  std::array<uint32_t, 3> corners;
  std::array<int64_t, 3> x;
};

// Returns twice the signed area of the triangle between two vectors.
inline Wide doubled_area(int64_t ax, int64_t ay, int64_t bx, int64_t by) {
  return static_cast<Wide>(ax) * by - static_cast<Wide>(ay) * bx;
}

// Regions bounded by directed edges on a strip of this width that is closed to a ring in x; for a plane, the
// width exceeds all x. The edges must form closed loops, and may meet only at their ends.
class ChartRegion {
 public:
  ChartRegion(std::span<const ChartVertex> vertices, std::span<const ChartEdge> edges, int64_t width)
      : vertices_(vertices), edges_(edges), width_(width) {}

  // The minimum and maximum winding number of all points, relative to that below all edges (y = -infinity);
  // the winding number above all edges; and vertices next to points with the minimum and with the maximum.
  struct Winding {
    int least = 0, largest = 0, above = 0;
    uint32_t least_at = 0, largest_at = 0;
  };
  // Returns nullopt if edges cross or touch; `conflict`, if not null, then receives vertices of such edges.
  Task<std::optional<Winding>> winding(std::vector<uint32_t>* conflict = nullptr) const;

  // Returns counter-clockwise triangles between the vertices that cover exactly the points with winding
  // number 1. Returns nullopt if edges cross or touch, if a winding number other than 0 or 1 occurs, or if it
  // is not 0 above or below all edges; `conflict`, if not null, then receives vertices of such a place.
  // Sweeps a line around the strip, divides the trapezoids that it passes by diagonals into polygons monotone
  // in x (R. Seidel: A simple and fast incremental randomized algorithm for computing trapezoidal
  // decompositions and for triangulating polygons, 1991), and triangulates these. O(n log n) comparisons; an
  // insertion also moves at most one entry per edge that the line crosses.
  Task<std::optional<std::vector<ChartTriangle>>> triangles(std::vector<uint32_t>* conflict = nullptr) const;

 private:
  std::span<const ChartVertex> vertices_;
  std::span<const ChartEdge> edges_;
  int64_t width_;
};

// Sweeps a line over the edges of a region, from x = 0 once around.
class ChartSweep {
 public:
  ChartSweep(std::span<const ChartVertex> vertices, std::span<const ChartEdge> edges, int64_t width);

  // Returns true if no edges cross or touch.
  Task<bool> run();

  // Returns vertices of edges that cross or touch, if run() returned false.
  const std::vector<uint32_t>& conflict() const { return conflict_; }

  const ChartRegion::Winding& winding() const { return winding_; }
  // Returns the diagonals. Each connects the end vertices of a trapezoid of winding number 1, unless a side
  // connects them.
  const std::vector<ChartEdge>& diagonals() const { return diagonals_; }

 private:
  // An edge from left to right. Ends before the start of the sweep have x < 0.
  struct Span {
    uint32_t left = 0, right = 0;
    int64_t left_x = 0, right_x = 0;
    int sign = 0;  // change of the winding number when crossing it upwards
  };
  // Left end of a trapezoid: a vertex or, if it began before the sweep, `unknown`, the index of an edge at
  // the start.
  struct Start {
    uint32_t vertex = 0;
    int64_t x = 0;
    int unknown = -1;
  };
  // An edge that the sweep line crosses, and the trapezoid above it.
  struct Active {
    Span span;
    int winding = 0;
    Start start;
  };
  struct Closed {
    int unknown;
    uint32_t vertex;
    int64_t x;
    Span below, above;
  };

  bool start_at_seam();
  bool pass(uint32_t v);
  bool insert_starting(uint32_t v, size_t at, int winding);
  int side_of(const Span& span, int64_t x, int64_t y) const;
  void close(size_t below, uint32_t v);
  void join(const Start& start, uint32_t v, int64_t x, const Span& below, const Span& above);
  bool end_at_seam();
  void note(int winding, uint32_t v);
  bool fail_at(uint32_t v, size_t first, size_t end);

  std::span<const ChartVertex> vertices_;
  int64_t width_;
  std::vector<Span> spans_;
  std::vector<uint32_t> first_, starting_;  // indices of spans by their left vertex
  std::vector<uint32_t> ending_;            // by vertex: number of spans that end there
  std::vector<uint32_t> order_;             // of vertices
  std::vector<Active> active_;              // from below
  std::vector<Span> at_seam_;
  std::vector<Closed> closed_;  // trapezoids that began before the sweep
  ChartRegion::Winding winding_;
  std::vector<ChartEdge> diagonals_;
  std::vector<uint32_t> conflict_;
};

}  // namespace kerf
