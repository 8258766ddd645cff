#pragma once

#include "core/world/world.h"

namespace kerf {

// Lets the spring of the world act on the body that it holds for one tick of so many seconds: its velocity
// and spin change as by a critically damped spring between the held point and the far end, which accelerates
// the point by at most kMostPull. The body wakes. Nothing happens without a spring, or if the piece does not
// exist, is pinned, hidden or has no mass.
void pull(World& world, double seconds);

inline constexpr double kPullFrequency = 20;  // rad/s, of the undamped spring with the mass that it feels
inline constexpr double kMostPull = 100;      // m/s^2

}  // namespace kerf
