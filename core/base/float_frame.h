#pragma once

#include <algorithm>
#include <cmath>
#include <glm/glm.hpp>

#include "core/base/vec3.h"

namespace kerf {

// How a body's doubles become floats, for the GPU and for shadows: (x - origin) times a power of two, about
// within [-1, 1], so that a mesh a millionth of a metre or 1e39 m wide, wherever it lies, is drawn alike.
struct FloatFrame {
  Vec3 origin{0};
  double scale = 1;

  static FloatFrame around(const Vec3& min, const Vec3& max) {
    const Vec3 half = (max - min) * 0.5;
    const double largest = std::max({half.x, half.y, half.z});
    FloatFrame frame{min + half, 1};
    if (largest > 0 && std::isfinite(largest)) frame.scale = std::ldexp(1.0, -std::ilogb(largest) - 1);
    return frame;
  }
  glm::dvec3 scaled(const Vec3& p) const { return (p - origin) * scale; }
  glm::vec3 to_float(const Vec3& p) const { return glm::vec3(scaled(p)); }
};

}  // namespace kerf
