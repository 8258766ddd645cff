#pragma once

#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

namespace kerf {

// Positions and directions in double, metres where they are lengths. glm's operations on these types are
// plain sums and products in the order written (and sqrt), so they give the same bits on every machine.
using Vec2 = glm::dvec2;
using Vec3 = glm::dvec3;

// z component of the cross product of two plane vectors; cross2(a, b) == -cross2(b, a) to the bit.
inline double cross2(Vec2 a, Vec2 b) { return a.x * b.y - a.y * b.x; }

}  // namespace kerf
