#pragma once

#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

namespace kerf {

// Positions and directions in double precision; lengths are in metres. glm evaluates operations on these
// types as plain sums, products and square roots in the order written, so that the results are the same to
// the bit on every machine.
using Vec2 = glm::dvec2;
using Vec3 = glm::dvec3;

// The z component of the cross product of two vectors in the plane; cross2(a, b) == -cross2(b, a) to the bit.
inline double cross2(Vec2 a, Vec2 b) { return a.x * b.y - a.y * b.x; }

// The lexicographic order of positions.
inline bool precedes(const Vec3& a, const Vec3& b) {
  if (a.x != b.x) return a.x < b.x;
  return a.y != b.y ? a.y < b.y : a.z < b.z;
}

}  // namespace kerf
