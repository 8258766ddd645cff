#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "core/base/parallel.h"
#include "core/base/result.h"
#include "core/mesh/build_mesh.h"
#include "core/mesh/mesh.h"

namespace kerf {

// What a mesh tool must preserve: some faces, and the edges between faces with a seam of UVs between them.
struct RemeshLimits {
  std::span<const FaceId> kept{};
  std::function<bool(FaceId, FaceId)> is_seam{};  // of two faces at an edge; null: there are no seams
};

// The new place of a face: for each of its quarters the origin of the triangle on which it lies.
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

// Returns the materials of the triangles, those of their origins. Precondition: `remeshed` was made of
// `mesh`.
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

}  // namespace kerf
