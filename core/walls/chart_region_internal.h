#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "core/base/task.h"

namespace kerf {

__extension__ using Wide = __int128;

// A vertex in the chart of a wall. Coordinates are whole numbers below 2^30, so that orientations are exact.
struct ChartVertex {
  int64_t x = 0, y = 0;
};

// An edge of the boundary of a region; the region lies on its left. `dx` is by how much x grows along it: on
// a strip that is closed to a ring, the ends alone do not say which way round it goes.
struct ChartEdge {
  uint32_t from = 0, to = 0;
  int64_t dx = 0;
};

// A triangle, counter-clockwise, with the x of its corners, which may lie beyond the width of the strip.
struct ChartTriangle {
  std::array<uint32_t, 3> corners;
  std::array<int64_t, 3> x;
};

// Twice the signed area of the triangle between two vectors.
inline Wide turn_of(int64_t ax, int64_t ay, int64_t bx, int64_t by) {
  return static_cast<Wide>(ax) * by - static_cast<Wide>(ay) * bx;
}

// Regions that directed edges bound on a strip of this width which is closed to a ring in x (for a plane, a
// width that exceeds all x). The edges must form closed loops, and may meet in their ends alone.
class ChartRegion {
 public:
  ChartRegion(std::span<const ChartVertex> vertices, std::span<const ChartEdge> edges, int64_t width)
      : vertices_(vertices), edges_(edges), width_(width) {}

  // The least and the largest number of times that the edges wind around a point, counted from below all of
  // them (y = -infinity), and that above them.
  // Both with a vertex where an edge leads to such a point.
  struct Winding {
    int least = 0, largest = 0, above = 0;
    uint32_t least_at = 0, largest_at = 0;
  };
  // Nothing where edges cross or touch; `conflict`, if given, then receives vertices of such edges.
  Resumable<std::optional<Winding>> winding(std::vector<uint32_t>* conflict = nullptr) const;

  // Triangles between the vertices, counter-clockwise, that cover exactly the points with winding number 1.
  // Nothing where edges cross or touch, where another number than 0 or 1 occurs, or below or above all edges
  // another one than 0. Sweeps a line around the strip, divides the trapezoids that it passes by diagonals
  // into polygons that are monotone in x (R. Seidel: A simple and fast incremental randomized algorithm for
  // computing trapezoidal decompositions and for triangulating polygons, 1991) and these into triangles.
  // O(n log n) with lists that are searched, but whose insertions cost the number of edges that the line
  // meets. `conflict`, if given, receives vertices where the edges bound no such region.
  Resumable<std::optional<std::vector<ChartTriangle>>> triangles(
      std::vector<uint32_t>* conflict = nullptr) const;

 private:
  std::span<const ChartVertex> vertices_;
  std::span<const ChartEdge> edges_;
  int64_t width_;
};

// A sweep of a line over the edges of a region, from x = 0 once around.
class ChartSweep {
 public:
  ChartSweep(std::span<const ChartVertex> vertices, std::span<const ChartEdge> edges, int64_t width);

  // Returns whether no edges cross or touch.
  Resumable<bool> run();

  // Otherwise vertices of edges that do.
  const std::vector<uint32_t>& conflict() const { return conflict_; }

  const ChartRegion::Winding& winding() const { return winding_; }
  // Between two vertices that lie on the left and the right end of a trapezoid of winding number 1 and are
  // not joined by a side of it.
  const std::vector<ChartEdge>& diagonals() const { return diagonals_; }

 private:
  // An edge from left to right. Ends before the start of the sweep have x < 0.
  struct Span {
    uint32_t left = 0, right = 0;
    int64_t left_x = 0, right_x = 0;
    int sign = 0;  // what is added to the winding number on the way up across it
  };
  // The left end of a trapezoid: a vertex, or the place in the list of edges at the start of the sweep.
  struct Start {
    uint32_t vertex = 0;
    int64_t x = 0;
    int unknown = -1;
  };
  // An edge that the line meets, and the trapezoid above it.
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
  std::vector<uint32_t> first_, starting_;  // spans by their left vertex
  std::vector<uint32_t> ending_;            // by vertex: the number of spans that end there
  std::vector<uint32_t> order_;             // of vertices
  std::vector<Active> active_;              // from below
  std::vector<Span> at_seam_;
  std::vector<Closed> closed_;  // trapezoids that began before the sweep did
  ChartRegion::Winding winding_;
  std::vector<ChartEdge> diagonals_;
  std::vector<uint32_t> conflict_;
};

}  // namespace kerf
