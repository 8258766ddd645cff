#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <glm/vec2.hpp>
#include <limits>
#include <span>
#include <vector>

#include "core/base/parallel.h"
#include "core/base/result.h"
#include "core/mesh/build_mesh.h"
#include "core/mesh/mesh.h"

namespace kerf {

// UVs at the corners of a face; NaN if it has none.
using FaceUvs = std::array<glm::dvec2, 3>;
inline bool has_uvs(const FaceUvs& uvs) { return !std::isnan(uvs[0].x); }

// Constraints on mesh tools: faces, edges at UV seams and UVs that must be preserved.
struct RemeshLimits {
  std::span<const FaceId> kept{};
  std::function<bool(FaceId, FaceId)> is_seam{};  // of two faces at an edge; null: there are no seams
  // By set and face slot; equal at a corner for faces that no seam separates. Only for simplify().
  std::span<const std::vector<FaceUvs>> uv_sets{};
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
  std::vector<std::vector<FaceUvs>> uv_sets;  // by set and triangle; empty if the tool does not carry them
  // The followed faces, if triangles are not all at the places of the faces from which they derive.
  std::vector<FollowedFace> followed;
};

// Returns the materials of the triangles, i.e. those of the faces from which they derive. Precondition:
// `remeshed` was computed from `mesh`.
std::vector<uint16_t> materials_of(const Remeshed& remeshed, const Mesh& mesh);

// Returns the colours of the positions: that of the vertex of the mesh at the position, otherwise that of the
// nearest point on the face from which a triangle at the position derives. Empty if the mesh has none. Same
// precondition. Expected linear time.
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

// The maximum factor by which a simplification stretches or compresses a texture on the surface, in any
// direction and compared with the original surface at the same UV. At 2, a texel differs as much as from the
// next level of a mipmap.
inline constexpr double kMaxUvStretch = 2;

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
// In every set of UVs, vertices keep theirs, and a collapse that would mirror the UVs of a face or exceed
// kMaxUvStretch anywhere on it is refused (see UvStretch). Meshes without UVs cost nothing for this.
//
// Fails with cancelled() when stopped; `progress` may be null. The result depends on the mesh and the target
// only: of equal errors the vertex with the lowest number comes first. Preconditions: the mesh has live
// faces, `limits.kept` and `followed` are live, and the error is positive. O(n log n); 3 to 10 us per removed
// face.
Result<Remeshed> simplify(const Mesh& mesh, const SimplifyTarget& target, const RemeshLimits& limits,
                          const Progress* progress, std::span<const FaceId> followed = {});

}  // namespace kerf
