#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/base/vec3.h"
#include "core/mesh/files/ear_clipping.h"
#include "core/mesh/soup.h"

namespace kerf {

// Cuts polygons of a mesh into triangles, each seen from its own side: the triangles turn the way of the
// polygon. Method: the polygon is laid into the plane of its Newell normal; there a quadrangle is cut along a
// diagonal inside it, a convex polygon into a fan, any other by ear clipping. Keeps scratch memory between
// polygons; one object a thread.
class Triangulator {
 public:
  // Appends exactly n - 2 triangles for a polygon of n corners; none for n < 3. Every corner must be an index
  // of a position; corners may repeat and positions need not be finite. The triangles cover a flat simple
  // polygon without overlap, and none of them is flat where that can be had. O(n) for convex polygons, near
  // O(n log n) for what occurs in files.
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
