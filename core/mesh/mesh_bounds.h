#pragma once

#include <limits>

#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/mesh/mesh.h"

namespace kerf {

// An axis-aligned box; low > high in every coordinate if it is empty.
struct MeshBounds {
  Vec3 low{std::numeric_limits<double>::max()}, high{std::numeric_limits<double>::lowest()};

  void add(const Vec3& l, const Vec3& h) {
    low = glm::min(low, l);
    high = glm::max(high, h);
  }
};

// The bounding box of the live faces of a mesh, or cancelled() when stopped; `progress` may be null. Linear
// in the number of vertices, on several threads.
Result<MeshBounds> bounds_of(const Mesh& mesh, const Progress* progress);

}  // namespace kerf
