#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "core/base/geometry.h"
#include "core/base/parallel.h"
#include "core/base/result.h"
#include "core/mesh/mesh.h"
#include "core/mesh/soup_topology.h"

namespace kerf {

// Returns the bounds of the live faces of a mesh, Bounds::none() if it has none, or cancelled() when stopped.
// `progress` may be null. Linear in the number of vertices, on several threads.
Result<Bounds> bounds_of(const Mesh& mesh, const Progress* progress);

// The squared distance (m^2) of a point from the nearest point of a triangle, which may be degenerate.
double squared_distance(const Vec3& p, const Triangle& t);

// The nearest point of a segment, which may have no length.
Vec3 nearest_on_segment(const Vec3& p, const Vec3& a, const Vec3& b);

// The nearest point of a triangle, which may be degenerate.
Vec3 nearest_point(const Vec3& p, const Triangle& t);

// How far two surfaces are from each other at most, measured both ways (the Hausdorff distance, m), from
// samples: corners, midpoints of sides and the middle of at most kMaxSampled triangles of each, spread
// evenly. Samples that cannot raise the result are left early (A. A. Taha, A. Hanbury: An efficient algorithm
// for calculating the exact Hausdorff distance, 2015). Fails with cancelled() when stopped; `progress` may be
// null. Precondition: neither surface is empty. O(n log n).
inline constexpr size_t kMaxSampled = 200'000;
Result<double> surface_distance(std::span<const Triangle> one, std::span<const Triangle> other,
                                const Progress* progress);

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
