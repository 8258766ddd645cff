#pragma once

#include <cstddef>
#include <vector>

#include "core/mesh/mesh.h"
#include "core/tree/aabb_tree.h"

namespace kerf {

// Statistics of the boxes of one level of a tree.
struct TreeLevel {
  size_t boxes = 0;
  size_t leaves = 0;  // boxes of single faces
  size_t edited = 0;  // leaves with AabbTree::Box::edited
  // Expected number of boxes of the level that a random line through the root meets: the sum of their surface
  // areas over that of the root (J. D. MacDonald, K. S. Booth: Heuristics for ray tracing using space
  // subdivision, 1990).
  double visits = 0;
  // Expected number of pairs of siblings that it meets where they overlap: the same sum over their
  // intersections.
  double overlap = 0;
};

// Measures the shape of a tree.
struct TreeStatistics {
  std::vector<TreeLevel> levels;  // the root first; empty for an empty tree

  // Cost of a random query by the surface area heuristic: expected number of boxes visited.
  double cost() const;
  double overlap() const;
  size_t edited() const;
  // Adds the statistics of another tree, level by level.
  void add(const TreeStatistics& other);
};

// Returns the statistics of a tree. Preconditions: those of AabbTree::for_each_box. O(boxes).
TreeStatistics tree_statistics(const AabbTree& tree, const Mesh& mesh);

}  // namespace kerf
