#pragma once

#include <cstddef>
#include <limits>
#include <span>

#include "core/mesh/remesh/remeshed.h"

namespace kerf {

// When to stop simplifying: as soon as so many faces are left, or before any vertex, edge midpoint or face
// centroid of the mesh gets farther than kShareForSamples of `error` (m) from the new surface. The surfaces
// are then within about `error` of each other.
struct SimplifyTarget {
  size_t faces = 0;
  double error = std::numeric_limits<double>::infinity();
};

// The part of the error that samples may take, because between them the surface was up to 1.6 times as far
// away, measured both ways.
inline constexpr double kShareForSamples = 0.6;

// Removes vertices by half-edge collapses over flat arrays, the one with the least quadric error first
// (M. Garland, P. S. Heckbert: Surface simplification using quadric error metrics, 1997). The queue is lazy:
// it has a lower bound of the error of each vertex, and whether and where a vertex may go is decided when it
// is the first.
//
// With a bound of the error one round allows each collapse to turn faces by 15 degrees. To a number of faces,
// the quadrics alone decide down to five times that number, and from there on rounds bound the distance of
// samples of the surface (see SurfaceSamples): each by twice the distance of the one before, until the faces
// are few enough. The quadrics know the planes of faces alone, not where these end, so that without that
// bound the largest distance between the surfaces was up to three times as large.
//
// Vertices keep their positions. Features (see FlatSheets) and the faces in `kept` stay, and so do components
// and topology: sheets that touch are never joined. More faces than the target may be left therefore. The
// faces in `followed` are told where they went (Remeshed::followed).
//
// Fails with cancelled() when stopped; `progress` may be null. The result depends on the mesh and the target
// alone: among equal errors the vertex with the lowest number goes first. Preconditions: the mesh has live
// faces, `kept` and `followed` are live, and the error is positive. O(n log n); 3 to 10 us a removed face.
Result<Remeshed> simplify(const Mesh& mesh, const SimplifyTarget& target, std::span<const FaceId> kept,
                          const Progress* progress, std::span<const FaceId> followed = {});

}  // namespace kerf
