#pragma once

#include <glm/geometric.hpp>
#include <optional>

#include "core/base/vec3.h"

namespace kerf {

// The influences on all bodies of a world.
struct Environment {
  Vec3 gravity{0, -9.81, 0};     // m/s^2
  std::optional<double> ground;  // m, the height of a plane on which bodies rest, against gravity
  // How many units of length of the world are a metre: 1000 where positions are in millimetres, and gravity,
  // the ground and all velocities with them. The lengths and speeds by which bodies touch and come to rest
  // follow it.
  double metre = 1;

  friend bool operator==(const Environment&, const Environment&) = default;

  // Unit, against gravity; +Y without gravity.
  Vec3 up() const {
    const double g = glm::length(gravity);
    return g > 0 ? -gravity / g : Vec3(0, 1, 0);
  }
};

}  // namespace kerf
