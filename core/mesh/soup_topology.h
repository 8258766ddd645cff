#pragma once

#include <array>
#include <cassert>
#include <cstdint>
#include <span>
#include <vector>

#include "core/base/parallel.h"
#include "core/base/result.h"

namespace kerf {

// The sides of a list of triangles, grouped by undirected edge. Side 3 t + i runs from corner i of triangle t
// to its next corner.
struct SoupEdges {
  std::vector<uint32_t> first;  // group g is sides[first[g]] .. sides[first[g + 1] - 1], ascending
  std::vector<uint32_t> sides;

  size_t count() const { return first.size() - 1; }
  size_t triangles() const { return sides.size() / 3; }
  // Returns the sides on an edge. Precondition: edge < count().
  std::span<const uint32_t> sides_of(uint32_t edge) const {
    assert(edge < count());
    return {sides.data() + first[edge], sides.data() + first[edge + 1]};
  }
};

// Groups the sides of triangles. Precondition: the corners are vertex numbers below `vertices`, and the three
// corners of a triangle differ. O(n log d) for vertices with at most d edges, multithreaded.
SoupEdges group_sides(std::span<const std::array<uint32_t, 3>> triangles, size_t vertices);
// Likewise, or fails with cancelled() when stopped. `progress` may be null.
Result<SoupEdges> group_sides(std::span<const std::array<uint32_t, 3>> triangles, size_t vertices,
                              const Progress* progress);

// Returns the group of each side. Linear time.
std::vector<uint32_t> edges_of_sides(const SoupEdges& edges);

// The triangles of a mesh by patch. A patch is a set of triangles that are connected over edges of exactly
// two triangles, across which an orientation can be propagated.
struct Patches {
  std::vector<uint32_t> first;  // patch p is triangles[first[p]] .. triangles[first[p + 1] - 1], ascending
  std::vector<uint32_t> triangles;  // sorted by patch; patches have the order of their lowest triangles
  std::vector<uint32_t> patch_of;   // by triangle
  // By patch: true if it bounds a volume, i.e. traverses each of its edges equally often in both directions.
  std::vector<bool> closed;

  size_t count() const { return closed.size(); }
  std::span<const uint32_t> triangles_of(size_t patch) const {
    return {triangles.data() + first[patch], triangles.data() + first[patch + 1]};
  }
};

// Finds the patches of a mesh, or fails with cancelled() when stopped. `progress` may be null. Precondition:
// `edges` are those of `triangles`. O(n log n).
Result<Patches> find_patches(const std::vector<std::array<uint32_t, 3>>& triangles, const SoupEdges& edges,
                             const Progress* progress);

// Returns the number of connected components: sets of triangles connected over edges with any number of
// triangles. Precondition: both arguments are of the same triangles. O(n log n), less if every edge has at
// most two triangles.
size_t count_components(const Patches& patches, const SoupEdges& edges);

}  // namespace kerf
