#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "core/mesh/mesh.h"
#include "core/mesh/soup_edges.h"

namespace kerf {

// The signed volume of the tetrahedron between an origin and a triangle (m^3), positive where the triangle is
// clockwise seen from the origin. Over closed faces the sum is the volume that they enclose.
inline double volume_under(const Triangle& t, const Vec3& origin) {
  return glm::dot(t[0] - origin, glm::cross(t[1] - origin, t[2] - origin)) / 6;
}

// What some triangles enclose. They are closed and consistently oriented where every edge, by the positions
// of its ends, is used as often in one direction as in the other; faces that share an edge belong to the same
// connected part, and so all parts are closed where the whole is. Nothing is not closed.
struct EnclosedVolume {
  bool closed = false;
  double volume = 0;  // m^3, the signed sum of the tetrahedra between an origin and each triangle
};

// The volume that live faces enclose. The order of the faces and the origin, which should lie near their
// middle, decide the rounding alone, where they are closed. O(faces + vertex slots).
EnclosedVolume enclosed_volume(const Mesh& mesh, std::span<const FaceId> faces, const Vec3& origin);
// That of all live faces.
EnclosedVolume enclosed_volume(const Mesh& mesh, const Vec3& origin);
// That of triangles whose corners are numbers of distinct positions; `edges` are their edges. O(triangles).
EnclosedVolume enclosed_volume(std::span<const Vec3> positions,
                               std::span<const std::array<uint32_t, 3>> triangles, const SoupEdges& edges,
                               const Vec3& origin);

// For each label below `labels` whether the live faces of the piece with this label are closed. Precondition:
// all labels in the mesh are below. O(face slots + vertex slots).
std::vector<bool> closed_pieces(const Mesh& mesh, uint32_t labels);

}  // namespace kerf
