#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <vector>

#include "core/base/assert.h"
#include "core/physics/collider/box.h"

namespace kerf {

// Which cells of a coarse grid over a box hold something: tells most of the places where nothing is at the
// cost of a few bits. Nothing is held as it is made.
class Occupancy {
 public:
  Occupancy() = default;
  // Cells are cubes, at most kMostCells along the longest side. The bounds may be flat but not empty.
  explicit Occupancy(const Box& bounds);

  // Marks all cells that a box meets; what lies outside the bounds is left out. O(cells of the box).
  void add(const Box& box);
  // Whether the box meets a cell that is marked: true wherever it meets a box that was added. Precondition:
  // the box is not empty. O(cells of the box).
  bool meets(const Box& box) const;

 private:
  static constexpr int kMostCells = 48;
  struct Range {
    std::array<int, 3> first, last;
  };
  // Finds the range of the cells of a box. Returns false if the box does not meet the bounds.
  bool cells_of(const Box& box, Range& range) const;
  uint64_t row_bits(const Range& range) const;

  int cell_of(double place, int axis) const {
    const double cell = (place - bounds_.min[axis]) * per_metre_;
    return static_cast<int>(std::min(std::max(cell, 0.0), last_[axis]));
  }

  Box bounds_;
  double per_metre_ = 0;
  std::array<int, 3> count_{};
  std::array<double, 3> last_{};  // the number of the last cell
  std::vector<uint64_t> rows_;    // along the first axis, by y + z * count_[1]
};

// Both ends are computed alike for what is added and what is asked for, so that rounding loses nothing.
inline bool Occupancy::cells_of(const Box& box, Range& range) const {
  if (rows_.empty() || !box.overlaps(bounds_)) return false;
  for (int k = 0; k < 3; ++k) {
    range.first[k] = cell_of(box.min[k], k);
    range.last[k] = cell_of(box.max[k], k);
  }
  return true;
}

inline uint64_t Occupancy::row_bits(const Range& range) const {
  const int count = range.last[0] - range.first[0] + 1;
  return ((uint64_t{1} << count) - 1) << range.first[0];
}

inline bool Occupancy::meets(const Box& box) const {
  KERF_ASSERT(box.min.x <= box.max.x && box.min.y <= box.max.y && box.min.z <= box.max.z);
  Range range;
  if (!cells_of(box, range)) return false;
  const uint64_t bits = row_bits(range);
  for (int z = range.first[2]; z <= range.last[2]; ++z) {
    for (int y = range.first[1]; y <= range.last[1]; ++y) {
      if (rows_[static_cast<size_t>(y + z * count_[1])] & bits) return true;
    }
  }
  return false;
}

}  // namespace kerf
