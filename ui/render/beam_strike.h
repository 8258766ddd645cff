#pragma once

#include <optional>

#include "core/world/world.h"

namespace kerf {

// Where a ray first meets one of the bodies that a beam meets (see cuttable): metres along it.
std::optional<double> first_hit(const World& world, const Pose& ray);

// Where a beam first meets one of those bodies, metres along it: by rays on its axis, around its radius and
// around that of the rim of what it burns, which lies so much farther out (m). Empty beyond `reach`.
std::optional<double> find_strike(const World& world, const Pose& beam, double radius, double overshoot,
                                  double reach);

}  // namespace kerf
