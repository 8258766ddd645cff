#pragma once

#include <functional>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "core/base/result.h"
#include "core/base/task.h"
#include "core/laser/laser.h"
#include "core/mesh/mesh.h"

namespace kerf {

// A side of a live face along a rim, counter-clockwise in that face; a wall runs along it the other way.
struct RimSide {
  FaceId face;
  VertexId from, to;
};

// Faces that close rims of a stroke in a solid. Corners below rim.size() index `rim`, the others `added`.
struct WallPatch {
  std::vector<RimSide> sides;  // closed by the faces
  std::vector<VertexId> rim;
  std::vector<Vec3> added;  // m
  std::vector<std::array<uint32_t, 3>> faces;
  // Connected walls: index of the wall by face of the patch and by side, and for each wall a face at its rim.
  std::vector<uint32_t> wall_of_face, wall_of_side;
  std::vector<FaceId> beside_wall;
};

// Properties of the stroke, in the frame of the mesh.
struct WallStroke {
  std::span<const BeamMove> moves;
  double radius = 0;  // m, > 0
  Interval range;     // m along the beam
  // Returns the signed distance from the boundary of the swept volume (m).
  std::function<double(const Vec3&)> distance;
  // Returns the faces that a ray along a unit vector crosses: 1 if it leaves the solid there, -1 if it
  // enters.
  std::function<std::vector<std::pair<FaceId, int>>(const Vec3&, const Vec3&)> crossings;
  // Returns by face slot the index of the face's connected part of the mesh, for all parts that have sides;
  // kNoPart for other faces. Parts that touch without a common edge are different.
  std::function<Task<std::vector<uint32_t>>()> parts;
};
inline constexpr uint32_t kNoPart = 0xffffffffu;

// Returns an error with a reason why something stays open, and a place.
Error left_open(const char* why, const Vec3& p);

// Walls of the closed parts, and a sentence with reason and place for each part that stays open.
struct MadeWalls {
  std::vector<WallPatch> patches;
  std::vector<std::string> left_open;
};

// Makes the walls: the part of the boundary of the swept volume that lies within the solids bounded by the
// sides. In the chart of that boundary (see WallChart) the sides are directed edges, and the walls lie
// where the winding number is 1; if the range of the beam ends in a solid, a flat cap closes the wall.
// Vertices of the rim stay; added ones lie on the boundary, so that edges deviate from it by at most
// kRimNear radii. The faces are counter-clockwise seen from outside the solid, i.e. from the beam, and
// every edge has two faces, counting those at the rim.
//
// All solids get one patch if possible. If their walls meet or overlap, e.g. if solids touch, each solid
// (an outer shell with its cavities) gets its own.
//
// Preconditions: `sides` are all sides without another face on their sheet of some connected parts of the
// mesh that were closed before; until completion all arguments live and the mesh is unchanged.
Task<MadeWalls> make_walls(const Mesh& mesh, std::span<const RimSide> sides, const WallStroke& stroke);

// A side of walls, as vertex indices of a patch.
using PatchSide = std::pair<uint32_t, uint32_t>;

// Reason why a patch does not fit a rim, and a vertex there.
struct PatchFault {
  const char* why;
  uint32_t vertex;
};

// Returns nullopt if every side of the patch has exactly one other face (of the patch, or beyond a side of
// the rim) and every side of the rim is one of the patch. O(n log n).
Task<std::optional<PatchFault>> fault_of(const WallPatch& patch, std::span<const PatchSide> rim);

// Computes the walls of the faces and of `rim`, beyond which are `sides`. Precondition: fault_of() is
// nullopt.
Task<Done> separate_walls(WallPatch& patch, std::span<const PatchSide> rim, std::span<const RimSide> sides);

}  // namespace kerf
