#include "core/game/match/recover.h"

#include <algorithm>

#include "core/base/tick.h"
#include "core/game/angle.h"
#include "core/game/arena/sight.h"
#include "core/game/vehicle/vehicle_bodies.h"

namespace kerf {

namespace {

constexpr double kTick = 1.0 / kTicksPerSecond;
constexpr double kLeaning = 0.35;     // the cosine of the lean from which on a vehicle is overturned
constexpr double kRoom = 2.5;         // m, around a vehicle
constexpr double kFreeSpeed = 3;      // m/s
constexpr double kStuckSpeed = 0.35;  // m/s
constexpr double kLift = 0.35;        // m

bool wants_away(const Vehicle& vehicle) { return std::abs(vehicle.controls.throttle) > Controls::kFull / 4; }

// A vehicle that stands on all its wheels and has not tried both ways is only in front of something.
bool is_caught(const Vehicle& vehicle) {
  return (vehicle.tried_ahead && vehicle.tried_back) ||
         std::any_of(vehicle.wheels.begin(), vehicle.wheels.end(),
                     [](const Wheel& w) { return w.attached && !w.grounded; });
}

void count(const Body& chassis, Vehicle& vehicle) {
  const double speed = glm::length(chassis.motion.velocity);
  const bool overturned = (chassis.placement.orientation * Vec3(0, 1, 0)).y < kLeaning;
  const bool stands = !overturned && wants_away(vehicle) && speed < kStuckSpeed;
  vehicle.overturned_s = overturned ? vehicle.overturned_s + kTick : 0;
  vehicle.stuck_s = stands ? vehicle.stuck_s + kTick : 0;
  vehicle.tried_ahead = stands && (vehicle.tried_ahead || vehicle.controls.throttle > 0);
  vehicle.tried_back = stands && (vehicle.tried_back || vehicle.controls.throttle < 0);
  if (!overturned && speed > kFreeSpeed) vehicle.free_place = chassis.placement;
}

// Whether no other body that moves is near a place.
bool is_free(const World& world, const Vehicle& vehicle, const Vec3& place) {
  const Sight sight(world);
  for (const Sight::Near& near : sight.bodies()) {
    const bool in_the_way = !near.body->pinned && !vehicle.has(near.id) && near.radius > 0.5;
    if (in_the_way && glm::distance(near.centre, place) < near.radius + kRoom) return false;
  }
  return true;
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
  count(chassis, vehicle);
  const bool overturned = vehicle.overturned_s >= times.righting;
  const bool stuck = vehicle.stuck_s >= times.stuck && is_caught(vehicle);
  if (!overturned && !stuck) return false;
  vehicle.overturned_s = vehicle.stuck_s = 0;
  vehicle.tried_ahead = vehicle.tried_back = false;
  const double ground = world.surroundings().ground.value_or(chassis.placement.position.y);
  // The middle of a vehicle on its roof is not where its origin is.
  const Vec3 middle = chassis.placement.to_world(chassis.middle());
  const bool goes_back = stuck && vehicle.free_place && is_free(world, vehicle, vehicle.free_place->position);
  chassis.placement =
      goes_back ? upright(*vehicle.free_place, ground)
                : upright({{middle.x, overturned ? middle.y : chassis.placement.position.y, middle.z},
                           chassis.placement.orientation},
                          ground);
  chassis.motion = Motion{};
  place_carried(world, vehicle);
  return true;
}

}  // namespace kerf
