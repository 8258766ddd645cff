#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/mesh/soup_edges.h"

namespace kerf {

// The triangles of a mesh by patch. A patch is a set of triangles that are connected over edges of exactly
// two triangles, i.e. one on which an orientation can be propagated.
struct Patches {
  std::vector<uint32_t> first;  // patch p is triangles[first[p]] .. triangles[first[p + 1] - 1], ascending
  std::vector<uint32_t> triangles;  // the patches in the order of their lowest triangles
  std::vector<uint32_t> patch_of;   // by triangle
  // Whether the patch is the boundary of a volume: on each of its edges it has as many triangles that
  // traverse the edge one way as triangles that traverse it the other way.
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

// The number of sets of triangles that are connected over edges with any number of triangles. Preconditions
// as above. O(n log n), less where every edge has two triangles at most.
size_t count_components(const Patches& patches, const SoupEdges& edges);

}  // namespace kerf
