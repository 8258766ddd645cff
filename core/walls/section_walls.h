#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "core/base/geometry.h"
#include "core/mesh/mesh.h"
#include "core/walls/make_walls.h"

namespace kerf {

// A plane, as the points x with dot(normal, x) = distance. The normal is a unit vector.
struct WallPlane {
  Vec3 normal{0, 1, 0};
  double distance = 0;  // m
};

// Walls in a plane, and further vertices at positions of patch.rim, which must be merged with these before
// the walls are added (see FaceAddition::weld): several sheets may touch at a vertex of a wall.
struct SectionWalls {
  WallPatch patch;
  std::vector<std::pair<uint32_t, VertexId>> welded;  // index in patch.rim, other vertex
};

// A prism on a section, or a hole in it, with kPegSides sides.
inline constexpr int kPegSides = 32;
struct SectionPeg {
  Vec3 centre{0};     // in the plane, m
  double radius = 0;  // of the corners, m
  double height = 0;  // along the normal of the plane, m; negative: the depth of a hole
};

struct Section {
  std::vector<SectionWalls> walls;
  std::vector<FaceId> seeds;           // a face per connected chain of sides
  std::vector<std::string> left_open;  // reason and place for each chain that is not a loop
  size_t pegs = 0;                     // number of pegs that the walls include
};

// Triangulates the region of a plane that is bounded by open sides, which lie in it up to rounding. The walls
// are counter-clockwise seen along -plane.normal, i.e. the normal points out of the solid. Loops within loops
// are holes. Adds vertices for pegs only. Loops that cross, as those of solids that overlap, are closed one
// by one, so that their walls overlap too; the volume is then the sum of theirs. Walls connect only faces of
// one piece.
//
// `pegs` that lie in the region become part of the walls; precondition: they do not meet its border or each
// other. Their vertices are SectionWalls::patch.added.
//
// With `closes` false, returns only the seeds. Precondition: the sides have no other face on their sheets.
// O(n log n) for n sides if no loops cross.
Section make_section(const Mesh& mesh, std::span<const RimSide> sides, const WallPlane& plane, bool closes,
                     std::span<const SectionPeg> pegs = {});

// Triangulates the region of a plane on the left of directed sides seen along -normal; `at` are their ends,
// in the plane up to rounding. Adds no vertices. Sides too short for the grid of triangulate_cap() get faces
// of their own. Returns nullopt if sides cross, or bound no finite region.
// Precondition: there is a side. O(n log n).
std::optional<std::vector<std::array<uint32_t, 3>>> triangulate_section(std::span<const Vec3> at,
                                                                        std::span<const PatchSide> sides,
                                                                        const Vec3& normal);

}  // namespace kerf
