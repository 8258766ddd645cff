#pragma once

#include "core/mesh/mesh.h"

namespace kerf {

// A ball around a point.
struct Ball {
  Vec3 centre{0};     // m
  double radius = 0;  // m
};

// The area of the part of a triangle that lies in a ball, m^2, to about a tenth of the radius: by bisection
// of the longest edge.
double area_within(const Triangle& t, const Ball& ball);

}  // namespace kerf
