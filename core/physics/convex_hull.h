#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "core/base/geometry.h"

namespace kerf {

// A convex polyhedron. Triangles are counter-clockwise seen from outside.
struct ConvexHull {
  std::vector<Vec3> positions;
  std::vector<std::array<uint32_t, 3>> triangles;
};

// Returns the convex hull of finite points; empty if they are coplanar up to its resolution, 1e-4 of their
// extent along each axis. Its vertices are some of the points. If the hull would have more than
// `max_vertices` vertices, returns the hull of a subset of them, selected greedily: each new vertex is the
// one farthest outside the hull of the previous ones. Precondition: max_vertices >= 4. O(n log n), and
// O(max_vertices^2) per vertex of the full hull.
ConvexHull convex_hull(std::span<const Vec3> points, size_t max_vertices);

// Returns the corners of both sides of a sheet: six points per triangle of non-zero area, offset from its
// corners along its normal by plus and minus half the thickness [m].
std::vector<Vec3> thickened_sheet(std::span<const Vec3> positions,
                                  std::span<const std::array<uint32_t, 3>> triangles, double thickness);

}  // namespace kerf
