#pragma once

#include <vector>

#include "core/game/vehicle/vehicle.h"
#include "core/world/world.h"

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
// A chassis of which less than kMinChassis is left is dead, too. What was cut off the bodies must be bodies
// of their own already (see release_pieces). O(faces of the vehicle).
Damage assess_damage(const World& world, Vehicle& vehicle);

// The area of the faces of a body, m^2.
double area_of(const Body& body);

inline constexpr double kMinPart = 0.5;      // of the area of a part
inline constexpr double kMinChassis = 0.25;  // of the area of the chassis

// Whether a body that came off another one, which was loaded as `loaded`, is made of whole parts: of every
// connected component of which it has faces, at least kCleanShare of the area is there, and it is no trifle
// (kMinCleanArea). False where the other one was loaded as a single component. O(faces).
bool is_clean(const Body& piece, const Body& loaded);

inline constexpr double kCleanShare = 0.97;    // of the area of a component
inline constexpr double kMinCleanArea = 0.05;  // m^2

// The change of velocity (m/s) within a tick from which on a vehicle comes to harm.
inline constexpr double kCrash = 8;

// Where a chassis was pushed whose velocity changed by `change` (m/s, in the world): the middle of that side
// of its box from which such a push comes, in the world, m.
Vec3 pushed_at(const Body& chassis, const Vec3& change);

// Lets go the joints of a chassis near a place (m, in the world) that a crash may break (see
// VehicleModel::breaks), the farther the more its velocity changed: `change` is at least kCrash. Returns
// whether there were any. What no joint holds any more is to be separated then. O(joints).
bool let_go_near(World& world, const Vehicle& vehicle, const Vec3& at, double change);

}  // namespace kerf
