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
// `progress` may be null. Linear in the number of vertices, multithreaded.
Result<Bounds> bounds_of(const Mesh& mesh, const Progress* progress);

// Returns the squared distance (m^2) of a point from a triangle, which may be degenerate. This and
// nearest_point() are accurate for edges of 1e-150 to 1e150 m.
double squared_distance(const Vec3& p, const Triangle& t);

// Returns the nearest point of a segment, which may have no length.
Vec3 nearest_on_segment(const Vec3& p, const Vec3& a, const Vec3& b);

// Returns the nearest point of a triangle, which may be degenerate.
Vec3 nearest_point(const Vec3& p, const Triangle& t);

// Returns the maximum distance between two surfaces, in both directions (the Hausdorff distance, m),
// estimated from samples: corners, midpoints of sides and centroids of at most kMaxSampled triangles of each,
// spread evenly. Samples that cannot raise the result are abandoned early (A. A. Taha, A. Hanbury: An
// efficient algorithm for calculating the exact Hausdorff distance, 2015). Fails with cancelled() when
// stopped; `progress` may be null. Precondition: neither surface is empty. O(n log n).
inline constexpr size_t kMaxSampled = 200'000;
Result<double> surface_distance(std::span<const Triangle> one, std::span<const Triangle> other,
                                const Progress* progress);

struct SurfaceMeasures {
  double area = 0;   // m^2
  Vec3 centroid{0};  // of the area, m; the first position if that is 0
};
// Measures triangles that index positions. Precondition: there is a position. Linear time.
SurfaceMeasures measure_surface(std::span<const Vec3> positions,
                                std::span<const std::array<uint32_t, 3>> triangles);

// Returns the signed volume of the tetrahedron between an origin and a triangle (m^3), positive if the
// triangle is clockwise seen from the origin. The sum over closed faces is the volume that they enclose.
inline double volume_under(const Triangle& t, const Vec3& origin) {
  return glm::dot(t[0] - origin, glm::cross(t[1] - origin, t[2] - origin)) / 6;
}

// The volume enclosed by triangles. Triangles are closed and consistently oriented if every edge, identified
// by the positions of its ends, is used equally often in both directions. Connected parts share no edges, so
// all parts are closed if the whole set is. An empty set is not closed.
struct EnclosedVolume {
  bool closed = false;
  double volume = 0;  // m^3, the signed sum of the tetrahedra between an origin and each triangle
};

// Computes the volume enclosed by live faces. The origin should be near their middle; if the faces are
// closed, it and the order of the faces affect only rounding. O(faces + vertex slots).
EnclosedVolume enclosed_volume(const Mesh& mesh, std::span<const FaceId> faces, const Vec3& origin);
// Likewise for all live faces.
EnclosedVolume enclosed_volume(const Mesh& mesh, const Vec3& origin);
// Likewise for triangles that index distinct positions; `edges` are their edges. O(triangles).
EnclosedVolume enclosed_volume(std::span<const Vec3> positions,
                               std::span<const std::array<uint32_t, 3>> triangles, const SoupEdges& edges,
                               const Vec3& origin);

// Returns, for each label below `labels`, whether the live faces of that piece are closed. Precondition: all
// labels in the mesh are below `labels`. O(face slots + vertex slots).
std::vector<bool> closed_pieces(const Mesh& mesh, uint32_t labels);
// The same for some live faces; other pieces count as open. O(faces + vertex slots).
std::vector<bool> closed_pieces(const Mesh& mesh, std::span<const FaceId> faces, uint32_t labels);

}  // namespace kerf
