#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "core/base/resumable.h"

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

}  // namespace kerf
