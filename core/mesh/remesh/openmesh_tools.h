#pragma once

#include <array>
#include <cstddef>
#include <span>

#include "core/mesh/remesh/remeshed.h"

namespace kerf {

enum class Subdivision {
  kLoop,  // each into four, and vertices move (C. Loop: Smooth subdivision surfaces based on triangles, 1987)
  kSqrt3,     // each into three, edges are flipped, and vertices move (L. Kobbelt: Sqrt(3) subdivision, 2000)
  kMidpoint,  // each into four, at the midpoints of its edges; the surface is unchanged
};

// Names for users and files, in the order of the enumerators.
inline constexpr std::array kSubdivisionNames{"loop", "sqrt3", "midpoint"};

constexpr size_t parts_of_face(Subdivision scheme) { return scheme == Subdivision::kSqrt3 ? 3 : 4; }

// Subdivides every face once, with the connectivity of OpenMesh's subdividers. Features (see Sheets) and the
// vertices of the faces in `limits.kept` do not move: a feature edge is split at its midpoint, or not at all
// by kSqrt3. Vertices move by the stencils of the papers, which OpenMesh computes without regard to features
// and with a cosine that differs between machines.
//
// Fails with cancelled() when stopped; `progress` may be null. The result depends on the mesh and the scheme
// only. Preconditions: the mesh has live faces, at most kMaxToSubdivide, and `limits.kept` are live. O(n log
// n).
inline constexpr size_t kMaxToSubdivide = size_t{1} << 27;
Result<Remeshed> subdivide(const Mesh& mesh, Subdivision scheme, const RemeshLimits& limits,
                           const Progress* progress);

// Moves every vertex half way to the middle of its neighbours, all at once, `times` times (the umbrella
// operator; L. Kobbelt et al.: Interactive multi-resolution modeling on arbitrary meshes, 1998), like
// OpenMesh's JacobiLaplaceSmoother. Features (see Sheets) and the vertices of the faces in `limits.kept` do
// not move. Closed surfaces shrink.
//
// Fails with cancelled() when stopped; `progress` may be null. The result depends on the mesh and `times`
// only. Preconditions: the mesh has live faces, `limits.kept` are live, and times <= kMaxSmoothing.
// O(n times + n log n).
inline constexpr size_t kMaxSmoothing = 1000;
Result<Remeshed> smooth(const Mesh& mesh, size_t times, const RemeshLimits& limits, const Progress* progress);

}  // namespace kerf
