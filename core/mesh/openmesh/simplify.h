#pragma once

#include <cstddef>
#include <limits>
#include <span>

#include "core/mesh/openmesh/remeshed.h"

namespace kerf {

// When to stop simplifying: as soon as so many faces are left, or before any vertex, edge midpoint or face
// centroid of the mesh gets farther than 0.6 of `error` (m) from the new surface. The surfaces are then
// within about `error` of each other.
struct SimplifyTarget {
  size_t faces = 0;
  double error = std::numeric_limits<double>::infinity();
};

// Removes vertices by half-edge collapses, the one with the least quadric error first (M. Garland,
// P. S. Heckbert: Surface simplification using quadric error metrics, 1997), with OpenMesh's Decimater and
// its modules for quadrics and for flipped normals. Vertices keep their positions. Features (see Sheets) and
// the faces in `kept` stay, and so do components: sheets that touch are never joined. More faces than the
// target may be left therefore. The faces in `followed` are told where they went (Remeshed::followed).
//
// Fails with cancelled() when stopped; `progress` may be null. The result depends on the mesh and the target
// alone: OpenMesh keeps its vertices in a heap by priority and, among equals, by the order of insertion.
// Preconditions: the mesh has live faces, `kept` and `followed` are live, and the error is positive.
// O(n log n).
Result<Remeshed> simplify(const Mesh& mesh, const SimplifyTarget& target, std::span<const FaceId> kept,
                          const Progress* progress, std::span<const FaceId> followed = {});

}  // namespace kerf
