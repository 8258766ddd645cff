#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/base/vec3.h"
#include "core/mesh/files/ear_clipping.h"
#include "core/mesh/files/soup.h"

namespace kerf {

// Triangulates polygons of a mesh; the triangles have the orientation of their polygon. The polygon is
// projected along the coordinate axis nearest to its Newell normal. A quadrangle is cut along a diagonal that
// lies inside it, a convex polygon becomes a fan, and any other polygon is triangulated by ear clipping. The
// object keeps scratch memory between polygons and must not be shared between threads.
class Triangulator {
 public:
  // Appends exactly n - 2 triangles for a polygon of n corners, none for n < 3. A planar simple polygon is
  // covered without overlap, and without degenerate triangles where possible. Corners may repeat, and
  // positions need not be finite. Precondition: all corners are indices of positions. O(n) for convex
  // polygons, about O(n log n) for those that occur in files.
  void append(std::span<const Vec3> positions, std::span<const uint32_t> polygon,
              std::vector<Soup::Triangle>& triangles);

 private:
  void append_quadrangle(std::span<const uint32_t> polygon, std::vector<Soup::Triangle>& triangles) const;

  std::vector<Vec3> corners_;
  std::vector<Vec2> flat_;
  std::vector<std::array<uint32_t, 3>> ears_;
  EarClipper clipper_;
};

}  // namespace kerf
