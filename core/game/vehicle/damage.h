#pragma once

#include <vector>

#include "core/game/vehicle/vehicle.h"
#include "core/world/world.h"

namespace kerf {

struct Damage {
  std::vector<size_t> wheels, vitals;  // indices in the description
  bool turret = false, barrel = false;
  bool died = false;
};

// Reads from the meshes which parts of a vehicle still work, and updates the vehicle. A part works while at
// least half of its loaded area is attached to its mount:
//
//   wheel, turret   half of the part is left in its body, half of that near its hub or pivot, and half of its
//                   mount is left in the chassis near there; otherwise it comes off as a free body. The same
//                   holds for the barrel on the turret.
//   vital part      half of its area is left in the chassis; otherwise the vehicle is dead.
//
// A vehicle with less than kMinChassis of its chassis is dead, too. Precondition: pieces that were cut off
// are bodies of their own (see release_pieces). O(faces of the vehicle).
Damage assess_damage(const World& world, Vehicle& vehicle);

// The area of the faces of a body [m^2].
double area_of(const Body& body);

inline constexpr double kMinPart = 0.5;      // of the area of a part
inline constexpr double kMinChassis = 0.25;  // of the area of the chassis

// Returns true if a body that was separated from `loaded` consists of whole parts: at least kCleanShare of
// the area of every connected component of which it has faces, and at least kMinCleanArea in total. False if
// `loaded` is a single component. O(faces).
bool is_clean(const Body& piece, const Body& loaded);

inline constexpr double kCleanShare = 0.97;    // of the area of a component
inline constexpr double kMinCleanArea = 0.05;  // m^2

// The change of velocity within a tick that damages a vehicle [m/s].
inline constexpr double kCrash = 8;

// The point of impact on a chassis whose velocity changed by `change` [m/s, in the world]: the middle of
// the side of its box that faces the push, in the world [m].
Vec3 pushed_at(const Body& chassis, const Vec3& change);

// Releases the breakable joints (see VehicleModel::breaks) of a chassis near a place [m, in the world],
// within a distance that grows with `change` [m/s], which is at least kCrash. Returns true if there were
// any; parts that no joint holds must be separated then. O(joints).
bool release_joints_near(World& world, const Vehicle& vehicle, const Vec3& at, double change);

}  // namespace kerf
