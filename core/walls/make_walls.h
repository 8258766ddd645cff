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

// A side of a live face along a rim, counter-clockwise in that face: a wall has it the other way round.
struct RimSide {
  FaceId face;
  VertexId from, to;
};

// Faces that close rims that a stroke has left in a solid. Corners below rim.size() are the vertices of the
// rims, the others new ones.
struct WallPatch {
  std::vector<RimSide> sides;  // that the faces close
  std::vector<VertexId> rim;
  std::vector<Vec3> added;  // m
  std::vector<std::array<uint32_t, 3>> faces;
  // The connected walls: which one each face of the patch is in, which one each side is closed by, and for
  // each a face at its rim.
  std::vector<uint32_t> wall_of_face, wall_of_side;
  std::vector<FaceId> beside_wall;
};

// What is needed to know about the stroke, in the frame of the mesh.
struct WallStroke {
  std::span<const BeamMove> moves;
  double radius = 0;  // m, > 0
  Interval range;     // m along the beam
  // The signed distance from the boundary of what the stroke has swept, in metres.
  std::function<double(const Vec3&)> distance;
  // The faces that a ray from a point along a unit vector crosses: 1 for those that it leaves, -1 for those
  // that it enters.
  std::function<std::vector<std::pair<FaceId, int>>(const Vec3&, const Vec3&)> crossings;
  // By face slot, the number of the connected part of the mesh that a face is in, for all parts that hold
  // sides; kNoPart for other faces. Parts that touch without an edge of their own count apart.
  std::function<Resumable<std::vector<uint32_t>>()> parts;
};
inline constexpr uint32_t kNoPart = 0xffffffffu;

// A reason why something stays open, with a place.
Error left_open(const char* why, const Vec3& p);

// The walls of the parts that could be closed, and for each of the others a sentence that says why not, and
// where.
struct MadeWalls {
  std::vector<WallPatch> patches;
  std::vector<std::string> left_open;
};

// Makes the walls: of the boundary of what a stroke has swept, the part that lies within the solids that the
// sides bound. In the chart of that boundary (see WallChart) the sides are directed edges, and the walls are
// where they wind around once; where the range of the beam ends in a solid, a flat cap closes the wall. The
// vertices of the rim stay; further ones lie on the boundary, so that edges deviate from it by no more than
// kRimNear radii. The faces are counter-clockwise seen from outside of the solid, i.e. from the beam, and
// every edge of a patch has two faces with those at the rim.
//
// All solids get one patch where that can be. Where their walls meet or overlap, as where solids touch, each
// solid gets its own: an outer shell with the cavities in it.
//
// Preconditions: `sides` are all sides without another face on their sheet of some connected parts of the
// mesh that were closed before; until the walls are made, all arguments live and the mesh stays unchanged.
Resumable<MadeWalls> make_walls(const Mesh& mesh, std::span<const RimSide> sides, const WallStroke& stroke);

// A side of walls, as indices of vertices of a patch.
using PatchSide = std::pair<uint32_t, uint32_t>;

// What is wrong with a patch of faces for a rim, and the vertex where.
struct PatchFault {
  const char* why;
  uint32_t vertex;
};

// Whether every side of the patch has exactly one other face: another one of the patch, or the one beyond a
// side of the rim, and every side of the rim is one of the patch. Nothing if so. O(n log n).
Resumable<std::optional<PatchFault>> fault_of(const WallPatch& patch, std::span<const PatchSide> rim);

// Fills in which connected wall the faces and the sides of the rim are in. `sides` are those beyond `rim`.
// Precondition: the patch has no fault.
Resumable<Done> tell_walls_apart(WallPatch& patch, std::span<const PatchSide> rim,
                                 std::span<const RimSide> sides);

}  // namespace kerf
