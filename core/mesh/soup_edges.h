#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "core/base/progress.h"
#include "core/base/result.h"

namespace kerf {

// The sides of a list of triangles, grouped by the undirected edge that they lie on. Side 3 t + i runs from
// corner i of triangle t to its next corner.
struct SoupEdges {
  std::vector<uint32_t> first;  // group g holds sides[first[g]] .. sides[first[g + 1] - 1], ascending
  std::vector<uint32_t> sides;
  std::vector<uint32_t> edge_of;  // the group of each side

  size_t count() const { return first.size() - 1; }
  std::span<const uint32_t> sides_of(uint32_t edge) const {
    return {sides.data() + first[edge], sides.data() + first[edge + 1]};
  }
};

// Corners are vertex numbers below `vertices`, three different ones a triangle. O(n log d) for vertices that
// start at most d edges.
SoupEdges group_sides(std::span<const std::array<uint32_t, 3>> triangles, size_t vertices);
// The same, or that it was stopped. `progress` may be null.
Result<SoupEdges> group_sides(std::span<const std::array<uint32_t, 3>> triangles, size_t vertices,
                              const Progress* progress);

// The number of sets of triangles that hang together over edges, whatever the number of triangles on an edge.
size_t count_components(const SoupEdges& edges);

}  // namespace kerf
