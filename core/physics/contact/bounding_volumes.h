#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <glm/common.hpp>
#include <glm/vector_relational.hpp>
#include <limits>
#include <span>
#include <vector>

#include "core/base/assert.h"
#include "core/base/geometry.h"

namespace kerf {

// A box along the axes; empty as it is made.
struct Box {
  Vec3 min{std::numeric_limits<double>::infinity()};
  Vec3 max{-std::numeric_limits<double>::infinity()};

  void add(const Vec3& p) {
    min = glm::min(min, p);
    max = glm::max(max, p);
  }
  void add(const Box& other) {
    min = glm::min(min, other.min);
    max = glm::max(max, other.max);
  }
  // The axis along which it is longest, of equal ones the first.
  int widest_axis() const {
    const Vec3 extent = max - min;
    if (extent.x >= extent.y && extent.x >= extent.z) return 0;
    return extent.y >= extent.z ? 1 : 2;
  }
  Box wider(double margin) const { return {min - margin, max + margin}; }
  // Touching boxes overlap too.
  bool overlaps(const Box& other) const {
    return min.x <= other.max.x && min.y <= other.max.y && min.z <= other.max.z && other.min.x <= max.x &&
           other.min.y <= max.y && other.min.z <= max.z;
  }
  bool holds(const Vec3& p) const {
    return min.x <= p.x && min.y <= p.y && min.z <= p.z && p.x <= max.x && p.y <= max.y && p.z <= max.z;
  }
};

// Items that lie beside each other, in a list and in space, and a ball around them.
struct Cluster {
  uint32_t begin = 0, end = 0;  // the range of the items
  Vec3 centre{0};
  double radius = 0;
};

// The clusters of a list of items in a hierarchy, so that what lies far away is left out with few tests.
class Clusters {
 public:
  // Whether `test` holds for the index of any item of the clusters for which, and for those around which,
  // `near` holds. In the order of the list; ends with the first.
  template <typename Near, typename Test>
  bool any_of(const Near& near, const Test& test) const {
    for (uint32_t n = 0; n < nodes_.size();) {
      const Node& node = nodes_[n];
      if (!near(node.cluster)) {
        n = node.next;
        continue;
      }
      if (node.next == ++n) {
        for (uint32_t i = node.cluster.begin; i < node.cluster.end; ++i) {
          if (test(i)) return true;
        }
      }
    }
    return false;
  }
  template <typename Near, typename Work>
  void for_each(const Near& near, const Work& work) const {
    any_of(near, [&](uint32_t i) {
      work(i);
      return false;
    });
  }

 private:
  friend class ClusterDivision;
  struct Node {
    Cluster cluster;
    uint32_t next = 0;  // the node after all that lie in this one: the following one for a cluster of items
  };
  std::vector<Node> nodes_;  // each followed by those that lie in it
};

struct Clustering {
  std::vector<uint32_t> order;  // the items, such that those of a cluster follow each other
  Clusters clusters;
};

// Divides segments (points are segments of length 0) into clusters of at most eight: lists that are longer
// are halved along the largest extent of their middles. Deterministic. O(n log^2 n).
Clustering make_clusters(std::span<const std::array<Vec3, 2>> segments);

// Which cells of a coarse grid over a box hold something: tells most of the places where nothing is at the
// cost of a few bits. Nothing is held as it is made.
class Occupancy {
 public:
  Occupancy() = default;
  // Cells are cubes, at most kMaxCells along the longest side. The bounds may be flat but not empty.
  explicit Occupancy(const Box& bounds);

  // Marks all cells that a box meets; what lies outside the bounds is left out. O(cells of the box).
  void add(const Box& box);
  // Whether the box meets a cell that is marked: true wherever it meets a box that was added. Precondition:
  // the box is not empty. O(cells of the box).
  bool meets(const Box& box) const;

 private:
  static constexpr int kMaxCells = 48;
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
