#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/mesh/files/soup.h"

namespace kerf {

// The triangles of a soup of which a mesh can be built, in its order.
struct UsableTriangles {
  std::vector<Soup::Triangle> triangles;  // of welded positions
  std::vector<uint16_t> materials;        // one per triangle; empty if the soup's are
  std::vector<MeshPart> parts;            // of these triangles; those without any are left out
  size_t degenerate = 0;                  // left out: two corners at the same position
  size_t non_finite = 0;                  // left out: a corner that is not a finite number
};

// Chooses the usable triangles, or fails with cancelled() when stopped. `welded` is what weld_positions()
// makes of the soup's positions. `progress` may be null. Linear time, on several threads.
Result<UsableTriangles> usable_triangles(const Soup& soup, std::span<const uint32_t> welded,
                                         const Progress* progress);

}  // namespace kerf
