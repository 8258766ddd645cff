#include "core/game/match/recover.h"

#include <algorithm>

#include "core/base/tick.h"
#include "core/game/angle.h"
#include "core/game/vehicle/vehicle_bodies.h"

namespace kerf {

namespace {

constexpr double kTick = 1.0 / kTicksPerSecond;
constexpr double kLeaning = 0.35;     // the cosine of the lean from which on a vehicle is overturned
constexpr double kStuckSpeed = 0.35;  // m/s
constexpr double kLift = 0.35;        // m

bool wants_away(const Vehicle& vehicle) { return std::abs(vehicle.controls.throttle) > Controls::kFull / 4; }

// A vehicle that stands on all its wheels is only in front of something, and can drive back.
bool is_hung_up(const Vehicle& vehicle) {
  return std::any_of(vehicle.wheels.begin(), vehicle.wheels.end(),
                     [](const Wheel& w) { return w.attached && !w.grounded; });
}

}  // namespace

Placement upright(const Placement& placement, double ground) {
  const double heading = heading_of(placement.orientation * Vec3(0, 0, 1));
  Vec3 position = placement.position;
  position.y = std::max(position.y, ground) + kLift;
  return {position, turn_about({0, 1, 0}, heading)};
}

bool recover_vehicle(World& world, Vehicle& vehicle, const MatchTimes& times) {
  if (!vehicle.alive || vehicle.wheels_attached() == 0) return false;
  Body& chassis = world.body(vehicle.chassis);
  const bool overturned = (chassis.placement.orientation * Vec3(0, 1, 0)).y < kLeaning;
  const bool stuck =
      wants_away(vehicle) && is_hung_up(vehicle) && glm::length(chassis.motion.velocity) < kStuckSpeed;
  vehicle.overturned_s = overturned ? vehicle.overturned_s + kTick : 0;
  vehicle.stuck_s = stuck ? vehicle.stuck_s + kTick : 0;
  if (vehicle.overturned_s < times.righting && vehicle.stuck_s < times.stuck) return false;
  vehicle.overturned_s = vehicle.stuck_s = 0;
  // The middle of a vehicle on its roof is not where its origin is.
  const Vec3 middle = chassis.placement.to_world(chassis.middle());
  const Vec3 down = -chassis.middle().y * Vec3(0, 1, 0);
  chassis.placement = upright({middle + (overturned ? Vec3(0) : down), chassis.placement.orientation},
                              world.surroundings().ground.value_or(middle.y));
  chassis.motion = Motion{};
  place_carried(world, vehicle);
  return true;
}

}  // namespace kerf
