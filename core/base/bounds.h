#pragma once

#include <limits>

#include "core/base/vec3.h"

namespace kerf {

// An axis-aligned box; the origin by default.
struct Bounds {
  Vec3 min{0}, max{0};

  // The bounds of nothing, from which bounds grow: min > max in every coordinate.
  static Bounds none() {
    return {Vec3(std::numeric_limits<double>::max()), Vec3(std::numeric_limits<double>::lowest())};
  }
  bool is_none() const { return min.x > max.x; }

  void add(const Vec3& point) { add(Bounds{point, point}); }
  void add(const Bounds& other) {
    min = glm::min(min, other.min);
    max = glm::max(max, other.max);
  }

  Vec3 centre() const { return 0.5 * min + 0.5 * max; }
  double diagonal() const { return glm::length(max - min); }

  friend bool operator==(const Bounds&, const Bounds&) = default;
};

}  // namespace kerf
