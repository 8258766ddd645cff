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
#include "core/mesh/mesh.h"

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

// A range of items that are close in space, and their bounding sphere.
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

// The occupied cells of a coarse grid over a box, a cheap test that rejects most queries in empty space.
// Initially empty.
class Occupancy {
 public:
  Occupancy() = default;
  // Cells are cubes, at most kMaxCells along the longest side. The bounds may be flat but not empty.
  explicit Occupancy(const Box& bounds);

  // Marks all cells that a box intersects; ignores the part of the box outside the bounds. O(cells of the
  // box).
  void add(const Box& box);
  // Returns true if a non-empty box intersects a marked cell; therefore true for every box that intersects an
  // added box. O(cells of the box).
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

// A corner of a wall of a solid body.
struct WallCorner {
  Vec3 at{0};      // in the frame of the body [m]
  Vec3 normal{0};  // unit, out of the body
};

// Contact features of a body in addition to its faces: points and straight chords of its sheet, in its frame
// (m).
struct Collider {
  struct Point {
    Vec3 at{0};
    Vec3 normal{0};   // unit, of the faces around it; zero if they cancel
    Vec3 outward{0};  // on a rim: unit, in the plane of the sheet and away from it; otherwise zero
  };
  // A straight piece of a rim or a crease.
  struct Chord {
    Vec3 from{0}, to{0};
  };

  std::vector<Point> points;
  std::vector<Chord> chords;
  // Used only to detect that the body passes through another one: further points, numbered after `points`,
  // and chords at full detail; equal to `chords` if none were left out there.
  std::vector<Point> guards;
  std::vector<Chord> fine_chords;
  // Clusters of the items of each list.
  Clusters point_clusters, chord_clusters, guard_clusters, fine_chord_clusters;
  Box bounds;       // of all vertices
  Occupancy space;  // cells of faces and chords
  // Points that can touch a plane: all vertices except those inside flat regions.
  std::vector<Vec3> corners;
  std::vector<WallCorner> wall_corners;  // see wall_corners(); make_collider() leaves them out
};

// Limits of the number of features.
struct ColliderSettings {
  size_t max_points = 96;
  size_t max_chords = 192;
  size_t max_guards = 512, max_fine_chords = 2048;
  // Maximum distance of a chord from its rim [m]; exceeded if there would otherwise be too many chords.
  double chord_error = 0.001;
};

// Builds the collider of all live faces of a mesh. Points: the ends of chords, extreme vertices, then
// vertices of rims and finally all others, selected as far apart as possible (T. Gonzalez: Clustering to
// minimize the maximum intercluster distance, 1985). Chords: rims and creases of more than 40 degrees as
// polygons (D. Douglas, T. Peucker, 1973). Guards: the remaining vertices, or a subset that is evenly spaced
// in their order. Deterministic. About O(faces log faces).
Collider make_collider(const Mesh& mesh, const ColliderSettings& settings = {});

// An edge at which a sheet ends or bends sharply.
struct FeatureEdge {
  VertexId from, to;
  FaceId face;       // a face on it
  bool rim = false;  // true if the sheet ends there, false for a crease
};

struct FeatureEdges {
  // Edges with one face, and edges whose faces differ in direction by more than 40 degrees.
  std::vector<FeatureEdge> lines;
  // Other edges with three or more faces, which may all lie on one side; `rim` is false.
  std::vector<FeatureEdge> seams;
};

// Returns the feature edges of a mesh, each once, in the order of the slots of their faces. `normals`: unit
// normals of the live faces by slot. O(faces).
FeatureEdges feature_edges(const Mesh& mesh, const std::vector<Vec3>& normals);

// A sequence of vertices along feature edges; closed if the first and last vertex are equal.
using FeatureLine = std::vector<VertexId>;

// Joins edges that meet in vertices of exactly two of them. O(n + highest vertex).
std::vector<FeatureLine> joined(const std::vector<FeatureEdge>& edges);

// Returns, for each point of a polyline, the smallest squared error (m^2) at which the simplified line omits
// the point: infinite for the ends, 0 for points omitted even at `least_error` (m). The simplified line for
// an error thus consists of the points whose value exceeds the squared error. Simplification keeps the ends
// and, recursively between two kept points, the point farthest from the segment between them while its
// distance exceeds the error (D. Douglas, T. Peucker: Algorithms for the reduction of the number of points
// required to represent a digitized line, 1973). A closed line, whose first and last points are equal, always
// keeps the point farthest from these. O(n^2) at worst, usually O(n log n).
std::vector<double> omission_errors(const std::vector<Vec3>& line, double least_error);

// Returns the simplified line for an error (m).
std::vector<Vec3> simplified(const std::vector<Vec3>& line, double error);

// Extends a selection by points that lie as far apart as possible. Repeatedly appends the index of the point
// farthest from all selected ones (T. Gonzalez, 1985), in a tie the first, until the selection has `most`
// members or every point coincides with a selected one. O(points * most).
void select_spread_points(const std::vector<Vec3>& points, size_t most, std::vector<uint32_t>& selected);

// Appends the indices of the points that are extreme along the axes and the space diagonals, each once.
void select_extreme(const std::vector<Vec3>& points, std::vector<uint32_t>& selected);

}  // namespace kerf
