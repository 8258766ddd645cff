#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "core/base/parallel.h"
#include "core/base/result.h"
#include "core/mesh/build_mesh.h"
#include "core/mesh/mesh.h"

namespace kerf {

// Where a face of the mesh went: for each of its quarters the face from which the triangle stems on which it
// lies now.
struct FollowedFace {
  FaceId face;
  std::array<FaceId, 4> quarters;
};

// The product of a tool, made of a mesh: triangles over welded positions, none of which has two corners at
// the same position.
struct Remeshed {
  std::vector<Vec3>
      positions;  // metres, in the frame of the mesh; those of vertices that stayed are bit-equal
  std::vector<std::array<uint32_t, 3>> triangles;  // indices of positions
  // The face of the mesh from which each triangle stems and takes its data, ascending.
  std::vector<FaceId> origins;
  // The faces that were to be followed, where triangles do not just lie where the faces did from which they
  // stem.
  std::vector<FollowedFace> followed;
};

// The materials of the triangles, those of the faces from which they stem. Precondition: `remeshed` was made
// of `mesh`.
std::vector<uint16_t> materials_of(const Remeshed& remeshed, const Mesh& mesh);

// The colours of the positions: that of the point of the surface which is nearest on the face from which a
// triangle at the position stems. Empty if the mesh has none. Same precondition.
std::vector<VertexColour> colours_of(const Remeshed& remeshed, const Mesh& mesh);

// Builds the mesh of the triangles with build_mesh; its face slots have their order. Names and parts are left
// empty. Same precondition. Fails with cancelled() when stopped; `progress` may be null. O(n log n).
Result<BuiltMesh> build_remeshed(const Remeshed& remeshed, const Mesh& mesh, const Progress* progress);

// Turns the closed parts of a mesh that lie in others and overlap with them, so that their volumes add up: a
// part inside another one becomes a cavity, and one inside a cavity a solid (see overlapping_patches). Faces
// that are not turned stay the same to the bit and in the same order. Fails with cancelled() when stopped;
// `progress` may be null. O(n log n).
Result<Remeshed> turn_shells(const Mesh& mesh, const Progress* progress);

}  // namespace kerf
