#pragma once

#include <algorithm>
#include <cmath>
#include <glm/glm.hpp>

#include "core/base/assert.h"
#include "core/base/geometry.h"

namespace kerf {

// Maps coordinates of a body from doubles to floats, for the GPU and for shadows: (x - origin) * scale, which
// is within about [-1, 1]. Precision does not depend on the size of a mesh, 1e-6 m or 1e39 m, or its
// position.
struct FloatFrame {
  Vec3 origin{0};    // metres, in the frame of the body
  double scale = 1;  // a power of two

  // Returns the frame for points in a box; scale 1 for an empty extent. Precondition: min <= max in each
  // component.
  static FloatFrame around(const Vec3& min, const Vec3& max) {
    KERF_ASSERT(min.x <= max.x && min.y <= max.y && min.z <= max.z);
    const Vec3 half = (max - min) * 0.5;
    const double largest = std::max({half.x, half.y, half.z});
    FloatFrame frame{min + half, 1};
    if (largest > 0 && std::isfinite(largest)) frame.scale = std::ldexp(1.0, -std::ilogb(largest) - 1);
    return frame;
  }
  // Map a point of the body; to_float also rounds it to single precision.
  glm::dvec3 scaled(const Vec3& p) const { return (p - origin) * scale; }
  glm::vec3 to_float(const Vec3& p) const { return glm::vec3(scaled(p)); }
};

}  // namespace kerf
