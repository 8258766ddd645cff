#pragma once

#include "core/game/vehicle/vehicle.h"
#include "core/world/world.h"

namespace kerf {

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
