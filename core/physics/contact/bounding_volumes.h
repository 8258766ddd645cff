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

// An axis-aligned box; initially empty.
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
  // Returns the axis of the longest extent, the first of equal ones.
  int widest_axis() const {
    const Vec3 extent = max - min;
    if (extent.x >= extent.y && extent.x >= extent.z) return 0;
    return extent.y >= extent.z ? 1 : 2;
  }
  Box wider(double margin) const { return {min - margin, max + margin}; }
  // Returns true also for boxes that only touch.
  bool overlaps(const Box& other) const {
    return min.x <= other.max.x && min.y <= other.max.y && min.z <= other.max.z && other.min.x <= max.x &&
           other.min.y <= max.y && other.min.z <= max.z;
  }
  bool holds(const Vec3& p) const {
    return min.x <= p.x && min.y <= p.y && min.z <= p.z && p.x <= max.x && p.y <= max.y && p.z <= max.z;
  }
};

// Items adjacent in a list and in space, and their bounding sphere.
struct Cluster {
  uint32_t begin = 0, end = 0;  // range of the items
  Vec3 centre{0};
  double radius = 0;
};

// Hierarchy of clusters over a list of items, which culls distant items with few tests.
class Clusters {
 public:
  // Returns true if `test` holds for the index of any item whose cluster, and all clusters around it,
  // satisfy `near`. Visits the items in list order and stops at the first hit.
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
    uint32_t next = 0;  // index of the node after this subtree: the next node for a cluster of items
  };
  std::vector<Node> nodes_;  // in preorder
};

struct Clustering {
  std::vector<uint32_t> order;  // items, those of a cluster in sequence
  Clusters clusters;
};

// Divides segments (points are segments of length 0) into clusters of at most eight: halves longer lists
// along the largest extent of their midpoints. Deterministic. O(n log^2 n).
Clustering make_clusters(std::span<const std::array<Vec3, 2>> segments);

// Occupied cells of a coarse grid over a box: rejects most queries in empty space cheaply. Initially empty.
class Occupancy {
 public:
  Occupancy() = default;
  // Cells are cubes, at most kMaxCells along the longest side. The bounds may be flat but not empty.
  explicit Occupancy(const Box& bounds);

  // Marks all cells that a box meets; ignores its part outside the bounds. O(cells of the box).
  void add(const Box& box);
  // Returns true if a non-empty box meets a marked cell, hence if it meets an added box. O(cells of the
  // box).
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
  std::array<double, 3> last_{};  // index of the last cell
  std::vector<uint64_t> rows_;    // bits along the first axis, by y + z * count_[1]
};

// Computes the ends identically for added and queried boxes, so that rounding loses no hit.
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
