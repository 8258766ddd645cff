#pragma once

#include <array>
#include <cassert>
#include <cstdint>
#include <span>
#include <vector>

#include "core/base/progress.h"
#include "core/base/result.h"

namespace kerf {

// The sides of a list of triangles, grouped by undirected edge. Side 3 t + i runs from corner i of triangle t
// to its next corner.
struct SoupEdges {
  std::vector<uint32_t> first;  // group g is sides[first[g]] .. sides[first[g + 1] - 1], ascending
  std::vector<uint32_t> sides;

  size_t count() const { return first.size() - 1; }
  size_t triangles() const { return sides.size() / 3; }
  // The sides on an edge. Precondition: edge < count().
  std::span<const uint32_t> sides_of(uint32_t edge) const {
    assert(edge < count());
    return {sides.data() + first[edge], sides.data() + first[edge + 1]};
  }
};

// Groups the sides of triangles. Precondition: the corners are vertex numbers below `vertices`, and the three
// corners of a triangle differ. O(n log d) for vertices with at most d edges, on several threads.
SoupEdges group_sides(std::span<const std::array<uint32_t, 3>> triangles, size_t vertices);
// Groups the sides, or fails with cancelled() when stopped. `progress` may be null.
Result<SoupEdges> group_sides(std::span<const std::array<uint32_t, 3>> triangles, size_t vertices,
                              const Progress* progress);

// The group of each side. Linear time.
std::vector<uint32_t> edges_of_sides(const SoupEdges& edges);

}  // namespace kerf
