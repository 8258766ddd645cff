#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/base/parallel.h"
#include "core/base/result.h"
#include "core/mesh/remesh/remeshed.h"
#include "core/world/rigid_body.h"
#include "core/world/world.h"
#include "core/world/world_delta.h"

namespace kerf {

// Returns the name of a piece in messages: "piece 2 of body 1".
std::string piece_words(const PieceId& piece);

// Returns true if the world has the piece, with at least one face.
bool has_faces(const World& world, const PieceId& piece);
Error no_such_piece(const PieceId& piece);

// Detaches the piece as a body of this generation if necessary (see detach), applies `edit` to it, and adds
// it to `list` of the delta. Returns an empty delta if `differs` returns false for the body of the piece.
// Fails with bad input, and does not change the world, if there is no such piece.
Result<Delta> edit_piece(World& world, const PieceId& piece, uint32_t generation,
                         std::vector<BodyId> Delta::*list, const std::function<bool(const Body&)>& differs,
                         const std::function<void(Body&)>& edit);

// Faces with constraints on remeshing, each list ascending.
struct TrackedFaces {
  std::vector<FaceId> kept;                     // must not change
  std::vector<FaceId> warm;                     // store heat, or once did
  std::function<bool(FaceId, FaceId)> is_seam;  // see RemeshLimits
  std::vector<std::vector<FaceUvs>> uv_sets;    // see RemeshLimits
};

using Remake =
    std::function<Result<Remeshed>(const Mesh& mesh, const TrackedFaces& tracked, const Progress* progress)>;

// Replaces a piece by a new body of this generation with the mesh that `remake` returns. The body keeps the
// label, the name, the placement and all other properties of the piece. Its faces count as loaded, with the
// materials, the energy and the part names of the faces from which they derive. Faces that carry joints, and
// the joints, are preserved. Returns an empty delta if the mesh is unchanged.
//
// Fails with bad input if there is no such piece, or if joints attach it to a separately moving piece,
// because a joint names a single body. Also fails like `remake`, if no face would be left, and with
// cancelled() when stopped; `progress` may be null. On failure the world is unchanged. O(n log n) plus the
// cost of `remake`.
Result<Delta> remesh_piece(World& world, const PieceId& piece, uint32_t generation, const Remake& remake,
                           const Progress* progress);

// A copy of faces of a body as plain arrays in world coordinates, exact to the bit if the body has not moved.
// Vertices at one position of the body are merged, but not those that coincide only by rounding in the world.
// So the corners of a triangle are three numbers, unless a split at a midpoint that rounds to an end of the
// edge has left it without one side. Vertices and faces keep the order of their slots.
struct Extract {
  std::vector<Vec3> positions;
  std::vector<std::array<uint32_t, 3>> triangles;
  std::vector<uint16_t> materials;    // one per triangle, or empty if the body has none
  std::vector<VertexColour> colours;  // one per position, or empty if the body has none
  double area = 0;                    // m^2
  Vec3 centroid{0};                   // centre of area, or of volume if solid, m
  size_t boundary_edges = 0;          // edges with one face
  std::optional<double> volume;       // enclosed by the faces, m^3; nullopt if they are not closed
  bool solid = false;                 // true if the body is solid and the faces enclose a volume
};

// Copies faces. Precondition: they are live and ascending. O(n log n).
Extract extract_faces(const Body& body, std::span<const FaceId> faces);

// Returns the mass properties of an extract, as a solid if it is one, else as a sheet; about its centroid, in
// world axes. O(n).
MassProperties mass_of(const Extract& extract, const Sheet& sheet);

// Returns the live faces of each non-empty piece of a body, in the order of labels; with `every_component`,
// of each connected component, in the order of their lowest faces. In a solid body, a closed component that
// bounds a cavity belongs to the component around it. O(n), or O(n log n + cavities * crossings of a ray) for
// the components of a solid body.
std::vector<std::vector<FaceId>> faces_by_piece(const Body& body, bool every_component);

}  // namespace kerf
