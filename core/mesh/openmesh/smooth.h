#pragma once

#include <cstddef>
#include <span>

#include "core/mesh/remesh/remeshed.h"

namespace kerf {

// Moves every vertex half the way to the middle of its neighbours, all at once, `times` times (the umbrella
// operator; L. Kobbelt et al.: Interactive multi-resolution modeling on arbitrary meshes, 1998), as
// OpenMesh's JacobiLaplaceSmoother does it. Features (see Sheets) and the vertices of the faces in `kept`
// stay. Closed surfaces shrink.
//
// Fails with cancelled() when stopped; `progress` may be null. The result depends on the mesh and the number
// alone. Preconditions: the mesh has live faces, `kept` are live, and it is
// at most kMostSmoothing times. O(n times + n log n).
inline constexpr size_t kMostSmoothing = 1000;
Result<Remeshed> smooth(const Mesh& mesh, size_t times, std::span<const FaceId> kept,
                        const Progress* progress);

}  // namespace kerf
