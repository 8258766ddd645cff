#pragma once

#include <cstdint>
#include <utility>
#include <vector>

#include "core/base/geometry.h"

namespace kerf {

struct Segment2 {
  Vec2 begin{0}, end{0};
};

// Returns the distance of a point from a segment [m].
double distance_to(const Segment2& segment, Vec2 point);

// Segments of the plane in a grid of square cells, for queries near a point.
class SegmentGrid {
 public:
  // Cells are at least `cell` wide [m, > 0], and so wide that segments lie in at most ten million of them,
  // plus three per segment. The segments must outlive the grid.
  SegmentGrid(const std::vector<Segment2>& segments, double cell);

  // Returns true if a segment is nearer to the point than this distance, which is at most `cell`.
  bool is_near(Vec2 point, double distance) const;
  // Returns pairs of segments that share a cell, ascending, each once. Stops and returns false beyond `most`
  // pairs.
  bool neighbours(size_t most, std::vector<std::pair<uint32_t, uint32_t>>& pairs) const;

 private:
  using Cell = std::pair<int64_t, int64_t>;

  void add(uint32_t index);
  int64_t index_of(double x, double origin) const;

  const std::vector<Segment2>& segments_;
  double cell_;
  Vec2 origin_{0};
  std::vector<std::pair<Cell, uint32_t>> entries_;  // sorted
};

}  // namespace kerf
