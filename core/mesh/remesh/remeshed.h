#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
#include <span>
#include <vector>

#include "core/base/parallel.h"
#include "core/base/result.h"
#include "core/mesh/build_mesh.h"
#include "core/mesh/mesh.h"

namespace kerf {

// Constraints on mesh tools: faces, and edges at UV seams, that must be preserved.
struct RemeshLimits {
  std::span<const FaceId> kept{};
  std::function<bool(FaceId, FaceId)> is_seam{};  // of two faces at an edge; null: there are no seams
};

// The position of a followed face after remeshing: for each of its quarters, the origin of the triangle on
// which it lies.
struct FollowedFace {
  FaceId face;
  std::array<FaceId, 4> quarters;
};

// The result of a mesh tool: triangles over welded positions, without two corners at the same position.
struct Remeshed {
  std::vector<Vec3> positions;  // metres, in the frame of the mesh; bit-equal for vertices that did not move
  std::vector<std::array<uint32_t, 3>> triangles;  // indices of positions
  // The face of the mesh from which each triangle derives and takes its data, ascending.
  std::vector<FaceId> origins;
  // The followed faces, if triangles are not all at the places of the faces from which they derive.
  std::vector<FollowedFace> followed;
};

// Returns the materials of the triangles, i.e. those of the faces from which they derive. Precondition:
// `remeshed` was computed from `mesh`.
std::vector<uint16_t> materials_of(const Remeshed& remeshed, const Mesh& mesh);

// Returns the colours of the positions: that of the nearest surface point on the face from which a triangle
// at the position derives. Empty if the mesh has none. Same precondition.
std::vector<VertexColour> colours_of(const Remeshed& remeshed, const Mesh& mesh);

// Builds the mesh of the triangles with build_mesh; face slots have the order of the triangles. Leaves names
// and parts empty. Same precondition. Fails with cancelled() when stopped; `progress` may be null.
// O(n log n).
Result<BuiltMesh> build_remeshed(const Remeshed& remeshed, const Mesh& mesh, const Progress* progress);

// Flips the closed parts of a mesh that are inside others and overlap with them, so that their volumes add
// up: a part inside another one becomes a cavity, and one inside a cavity a solid (see overlapping_patches).
// Other faces stay the same to the bit and in the same order. Fails with cancelled() when stopped; `progress`
// may be null. O(n log n).
Result<Remeshed> turn_shells(const Mesh& mesh, const Progress* progress);

// The end of a simplification: either `faces` faces are left, or the next collapse would move the new surface
// farther than kShareForSamples * `error` (m) from a vertex, edge midpoint or face centroid of the mesh. Both
// surfaces are then within about `error` of each other.
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
