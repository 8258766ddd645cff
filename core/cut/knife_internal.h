#pragma once

#include <functional>
#include <span>
#include <vector>

#include "core/cut/cut_stages.h"
#include "core/cut/knife.h"
#include "core/walls/section_walls.h"

namespace kerf {

// Parts that the cuts along a plane and along a path share.

inline double distance_from(const WallPlane& plane, const Vec3& p) {
  return glm::dot(plane.normal, p) - plane.distance;
}

// Returns the distance from a plane below which a point of the body counts as lying on it (see kOnKnife).
double distance_on(const WallPlane& plane, const Body& body);

// Returns the point where a plane crosses an edge of a face, equal for all faces of the edge and different
// from their opposite corners. Precondition: the ends lie on different sides, further away than
// distance_on().
Vec3 plane_crossing(const Mesh& mesh, const WallPlane& plane, const Mesh::Side& edge);

// Returns the sides that have no other face on their sheet, with their present vertices: disconnecting edges
// replaces vertices, but not positions. Appends the faces of the other sides to `others`.
std::vector<RimSide> open_sides(const Mesh& mesh, std::span<const Mesh::Side> sides,
                                std::vector<FaceId>& others);

// Returns centres of pegs in a section, given by the sides of one side of a cut: the first as far as possible
// from its border, the next as far as possible from the others; or in rows, if more of them fit so.
// has_room(centre, radius) returns true if the solid has room for a peg and its hole within this radius.
std::vector<Vec3> peg_centres(const Mesh& mesh, std::span<const Mesh::Side> sides, const WallPlane& plane,
                              const Pegs& pegs, const std::function<bool(const Vec3&, double)>& has_room);

// Adds walls, and connects the parts at their rim.
void add_section(BodyStep& step, const SectionWalls& walls);

// Returns the error of a body with too many faces.
Error too_many_knife_faces(size_t max_faces);

}  // namespace kerf
