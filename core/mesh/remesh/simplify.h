#pragma once

#include <cstddef>
#include <limits>
#include <span>

#include "core/mesh/remesh/remeshed.h"

namespace kerf {

// When to stop simplifying: once `faces` faces are left, or before any vertex, edge midpoint or face centroid
// of the mesh gets farther than kShareForSamples of `error` (m) from the new surface. The surfaces are then
// within about `error` of each other.
struct SimplifyTarget {
  size_t faces = 0;
  double error = std::numeric_limits<double>::infinity();
};

// The fraction of the error available to samples, because between them the surface was up to 1.6 times as
// far, both ways.
inline constexpr double kShareForSamples = 0.6;

// Removes vertices by half-edge collapses over flat arrays, in the order of the quadric error (M. Garland, P.
// S. Heckbert: Surface simplification using quadric error metrics, 1997). The queue is lazy: it has a lower
// bound of the error of each vertex; its best allowed collapse is determined when it is the first.
//
// With a bound of the error, one round allows each collapse to turn faces by 15 degrees. With a target number
// of faces, only the quadrics are used down to five times that number, and from there on rounds bound the
// distance of samples of the surface (see SurfaceSamples), each by twice the distance of the previous one,
// until the target is reached. Quadrics measure the planes of faces, not their extent; without that bound the
// maximum distance between the surfaces was up to three times as large.
//
// Vertices keep their positions. Features (see FlatSheets), the faces in `limits.kept`, components and
// topology are preserved: sheets that touch are never joined. More faces than the target may therefore
// remain. The new places of the faces in `followed` are in Remeshed::followed.
//
// Fails with cancelled() when stopped; `progress` may be null. The result depends on the mesh and the target
// only: of equal errors the vertex with the lowest number comes first. Preconditions: the mesh has live
// faces, `limits.kept` and `followed` are live, and the error is positive. O(n log n); 3 to 10 us per removed
// face.
Result<Remeshed> simplify(const Mesh& mesh, const SimplifyTarget& target, const RemeshLimits& limits,
                          const Progress* progress, std::span<const FaceId> followed = {});

}  // namespace kerf
