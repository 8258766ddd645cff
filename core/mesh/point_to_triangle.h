#pragma once

#include "core/mesh/mesh.h"

namespace kerf {

// The squared distance (m^2) of a point from the nearest point of a triangle, which may be degenerate.
double squared_distance(const Vec3& p, const Triangle& t);

// The nearest point of a segment, which may have no length.
Vec3 nearest_on_segment(const Vec3& p, const Vec3& a, const Vec3& b);

// The nearest point of a triangle, which may be degenerate.
Vec3 nearest_point(const Vec3& p, const Triangle& t);

}  // namespace kerf
