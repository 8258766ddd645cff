#pragma once

#include <vector>

#include "core/game/vehicle/vehicle.h"

namespace kerf {

// What a vehicle has lost.
struct Damage {
  std::vector<size_t> wheels, vitals;  // by their indices in the description
  bool turret = false, barrel = false;
  bool died = false;
};

// Reads from the meshes which parts of a vehicle still work, and brings the vehicle up to date. A part works
// while at least half of its area as loaded hangs on its mount:
//
//   wheel, turret   half of the part is left in its body, half of that near its hub or pivot, and half of its
//                   mount is left in the chassis near there; otherwise it comes off and is a free body. The
//                   barrel hangs on the turret in the same way.
//   vital part      half of its area is left in the chassis; otherwise the vehicle is dead.
//
// A chassis of which less than kLeastChassis is left is dead, too. What was cut off the bodies must be bodies
// of their own already (see release_pieces). O(faces of the vehicle).
Damage assess_damage(const World& world, Vehicle& vehicle);

// The area of the faces of a body, m^2.
double area_of(const Body& body);

inline constexpr double kLeastPart = 0.5;      // of the area of a part
inline constexpr double kLeastChassis = 0.25;  // of the area of the chassis

}  // namespace kerf
