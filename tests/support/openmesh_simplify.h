#pragma once

#include <span>

#include "core/mesh/remesh/remeshed.h"

namespace kerf {

// The peer of simplify(): OpenMesh's Decimater with its modules for quadrics and for flipped normals.
//
// Fails with cancelled() when stopped; `progress` may be null. The result depends on the mesh and the target
// alone: OpenMesh keeps its vertices in a heap by priority and, among equals, by the order of insertion.
// Preconditions: the mesh has live faces, `kept` and `followed` are live, and the error is positive.
// O(n log n).
Result<Remeshed> simplify_by_openmesh(const Mesh& mesh, const SimplifyTarget& target,
                                      const RemeshLimits& limits, const Progress* progress,
                                      std::span<const FaceId> followed = {});

}  // namespace kerf
