#pragma once

#include <span>

#include "core/game/arena/free_space.h"
#include "core/game/driver/traffic.h"

namespace kerf {

// How a vehicle stands and moves, seen from above.
struct Course {
  Vec3 at{0};              // m, the middle between the axles
  double heading = 0;      // rad, see direction_of
  double speed = 0;        // m/s, forward
  double wheelbase = 2.6;  // m
  double reach = 1.3;      // m, from the middle to the discs at the front and at the rear
};

// A way of driving for the next moment.
struct Arc {
  double steer = 0;  // -1 .. 1, of the full lock, positive to the left
  double speed = 0;  // m/s that the driver goes for; negative backwards
};

// Where an arc leads.
struct ArcEnd {
  Vec3 at{0};
  double heading = 0;
  double free_s = 0, free_m = 0;  // until it meets something, or its end
  double room = 0;                // m, the least clearance on the way
};

inline constexpr double kArcTime = 1.8;  // s

// Drives a vehicle along an arc in the plane (the kinematic bicycle) for kArcTime, or until one of three
// discs that cover it has no room or meets `traffic`, which goes on as it moves. What the vehicle is in
// already only counts if it gets deeper into it. Based on: D. Fox, W. Burgard, S. Thrun: The dynamic window
// approach to collision avoidance, 1997.
ArcEnd follow_arc(const FreeSpace& space, std::span<const Disc> traffic, const Course& course,
                  const Arc& arc);

}  // namespace kerf
