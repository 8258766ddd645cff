#pragma once

#include <array>
#include <cstdint>
#include <vector>

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
  // Of the cells of a box; nothing if it does not meet the bounds.
  bool cells_of(const Box& box, Range& range) const;
  uint64_t row_bits(const Range& range) const;

  Box bounds_;
  double per_metre_ = 0;
  std::array<int, 3> count_{};
  std::vector<uint64_t> rows_;  // along the first axis, by y + z * count_[1]
};

}  // namespace kerf
