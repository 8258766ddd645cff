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

// A side of a live face along a rim, counter-clockwise in that face; a wall traverses it in the opposite
// direction.
struct RimSide {
  FaceId face;
  VertexId from, to;
};

// Faces that close rims of a stroke in a solid. A corner i refers to rim[i] if i < rim.size(), else to
// added[i - rim.size()].
struct WallPatch {
  std::vector<RimSide> sides;  // sides that the faces close
  std::vector<VertexId> rim;
  std::vector<Vec3> added;  // m
  std::vector<std::array<uint32_t, 3>> faces;
  // Walls, i.e. connected sets of faces: the wall index of each face of the patch and of each side; and, by
  // wall, a face of the mesh at its rim.
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
  // Returns the faces that a ray along a unit vector crosses, each with 1 if the ray leaves the solid there
  // and -1 if it enters.
  std::function<std::vector<std::pair<FaceId, int>>(const Vec3&, const Vec3&)> crossings;
  // Returns by face slot the index of the face's connected part of the mesh, for all parts that have sides;
  // kNoPart for other faces. Parts that touch without a common edge are different.
  std::function<Task<std::vector<uint32_t>>()> parts;
};
inline constexpr uint32_t kNoPart = 0xffffffffu;

// Returns an error that states why a part stays open, and the place without its unit.
Error left_open(const char* why, const Vec3& p);

// Walls of the closed parts, and a sentence with reason and place for each part that stays open.
struct MadeWalls {
  std::vector<WallPatch> patches;
  std::vector<std::string> left_open;
};

// Creates the walls: the part of the boundary of the swept volume that lies inside the solids and is bounded
// by the sides. In the chart of this boundary (see WallChart) the sides are directed edges, and the walls are
// the region with winding number 1; if the range of the beam ends in a solid, a flat cap closes the wall.
// Vertices of the rim are kept; added vertices lie on the boundary, and edges deviate from it by at most
// kRimNear radii. The faces are counter-clockwise seen from outside the solid, i.e. from the beam. Every edge
// has two faces, including the faces at the rim.
//
// All solids share one patch if possible. If their walls meet or overlap, e.g. because solids touch, each
// solid (an outer shell with its cavities) gets a patch of its own.
//
// Preconditions: `sides` are all boundary sides of some connected parts of the mesh that were closed before
// the stroke. The arguments must outlive the task, and the mesh must not change until it completes.
Task<MadeWalls> make_walls(const Mesh& mesh, std::span<const RimSide> sides, const WallStroke& stroke);

// A side of walls, as vertex indices of a patch.
using PatchSide = std::pair<uint32_t, uint32_t>;

// The reason why a patch does not fit a rim, and a vertex at that place.
struct PatchFault {
  const char* why;
  uint32_t vertex;
};

// Checks a patch. Returns nullopt if every side of a face has exactly one other face (of the patch, or across
// the rim), and every side of the rim is a side of the patch. O(n log n).
Task<std::optional<PatchFault>> fault_of(const WallPatch& patch, std::span<const PatchSide> rim);

// Computes the wall indices of the faces and of the sides of `rim`; `sides` are the same sides in the mesh.
// Precondition: fault_of() returns nullopt.
Task<Done> separate_walls(WallPatch& patch, std::span<const PatchSide> rim, std::span<const RimSide> sides);

}  // namespace kerf
