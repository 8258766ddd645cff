#pragma once

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/glm.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <limits>

#include "core/base/assert.h"
#include "core/base/tolerances.h"

namespace kerf {

// Positions and directions in double precision; lengths are in metres. glm evaluates operations on these
// types as plain sums, products and square roots in the order written, bit-identical on every machine.
using Vec2 = glm::dvec2;
using Vec3 = glm::dvec3;

// Returns the z component of the cross product; cross2(a, b) == -cross2(b, a) to the bit.
inline double cross2(Vec2 a, Vec2 b) { return a.x * b.y - a.y * b.x; }

// The lexicographic order of positions.
inline bool lexicographic_less(const Vec3& a, const Vec3& b) {
  if (a.x != b.x) return a.x < b.x;
  return a.y != b.y ? a.y < b.y : a.z < b.z;
}

// Returns true if a squared length read from a file is that of a unit vector or quaternion; see kUnitSlack.
constexpr bool is_unit_length2(double length2, double slack = kUnitSlack) {
  return length2 - 1 < slack && 1 - length2 < slack;
}

// Returns true if v is a unit vector; for preconditions. The slack exceeds that of files, because a direction
// may have been rotated by an orientation that has an error of its own.
inline bool is_unit(const Vec3& v) { return is_unit_length2(glm::dot(v, v), 16 * kUnitSlack); }

// Returns true if two unit vectors are opposite up to rounding, so that no direction lies between them; see
// kOpposite. Precondition: both are unit vectors.
inline bool are_opposite(const Vec3& a, const Vec3& b) {
  const Vec3 sum = a + b;
  return glm::dot(sum, sum) < kOpposite * kOpposite;
}

// A closed interval of the real line; empty if low > high.
struct Interval {
  double low = 0;
  double high = 0;
};

// An axis-aligned box; by default the origin.
struct Bounds {
  Vec3 min{0}, max{0};

  // Empty bounds, with min > max in every coordinate; add() extends them.
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

// A ray, or the pose of a beam: starts at `origin` (m) and has the unit vector `direction`. The frame depends
// on the use: the world's for a stroke, the body's for a query of its tree.
struct Pose {
  Vec3 origin{0};
  Vec3 direction{0, 0, -1};
};

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
