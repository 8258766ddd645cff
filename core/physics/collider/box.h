#pragma once

#include <glm/common.hpp>
#include <glm/vector_relational.hpp>
#include <limits>

#include "core/base/vec3.h"

namespace kerf {

// A box along the axes; empty as it is made.
struct Box {
  Vec3 min{std::numeric_limits<double>::infinity()};
  Vec3 max{-std::numeric_limits<double>::infinity()};

  void add(const Vec3& p) {
    min = glm::min(min, p);
    max = glm::max(max, p);
  }
  void add(const Box& other) {
    min = glm::min(min, other.min);
    max = glm::max(max, other.max);
  }
  // The axis along which it is longest, of equal ones the first.
  int widest_axis() const {
    const Vec3 extent = max - min;
    if (extent.x >= extent.y && extent.x >= extent.z) return 0;
    return extent.y >= extent.z ? 1 : 2;
  }
  Box wider(double margin) const { return {min - margin, max + margin}; }
  // Touching boxes overlap too.
  bool overlaps(const Box& other) const {
    return min.x <= other.max.x && min.y <= other.max.y && min.z <= other.max.z && other.min.x <= max.x &&
           other.min.y <= max.y && other.min.z <= max.z;
  }
  bool holds(const Vec3& p) const {
    return min.x <= p.x && min.y <= p.y && min.z <= p.z && p.x <= max.x && p.y <= max.y && p.z <= max.z;
  }
};

}  // namespace kerf
