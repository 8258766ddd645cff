#pragma once

#include <span>

#include "core/mesh/remesh/remeshed.h"
#include "core/mesh/remesh/simplify_target.h"

namespace kerf {

// The same as simplify() with OpenMesh's Decimater and its modules for quadrics and for flipped normals,
// which takes some twenty times as long. Journals that do not say by which method a piece was simplified mean
// this one.
//
// Fails with cancelled() when stopped; `progress` may be null. The result depends on the mesh and the target
// alone: OpenMesh keeps its vertices in a heap by priority and, among equals, by the order of insertion.
// Preconditions: the mesh has live faces, `kept` and `followed` are live, and the error is positive.
// O(n log n).
Result<Remeshed> decimate(const Mesh& mesh, const SimplifyTarget& target, std::span<const FaceId> kept,
                          const Progress* progress, std::span<const FaceId> followed = {});

}  // namespace kerf
