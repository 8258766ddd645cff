#include "core/game/match/vehicle_placement.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/base/deterministic_math.h"
#include "core/base/tick.h"
#include "core/game/arena/sight.h"
#include "core/game/driver/steering.h"
#include "core/game/vehicle/vehicle.h"

namespace kerf {

namespace {

constexpr double kStartsAway = 30;  // m, length of the route of enemies to the player
constexpr double kGap = 2.5;        // m, between a new vehicle and other bodies

double length_of(const std::vector<Vec3>& way) {
  double length = 0;
  for (size_t i = 1; i < way.size(); ++i) length += glm::distance(way[i - 1], way[i]);
  return length;
}

bool has_room(const Vec3& place, const FreeSpace& space, std::span<const Disc> traffic) {
  if (space.spots() > 0 && !space.has_room(space.spot_at(place))) return false;
  return std::ranges::none_of(
      traffic, [&](const Disc& disc) { return glm::distance(disc.centre, place) < disc.radius + kGap; });
}

}  // namespace

std::vector<Start> starts_by_way(const ArenaDescription& arena, const FreeSpace& space, const Vec3& player) {
  std::vector<std::pair<double, Start>> starts;
  for (const Start& start : arena.enemies) {
    const std::vector<Vec3> way = find_route(space, {}, start.position, player);
    const double length = way.empty() ? glm::distance(start.position, player) : length_of(way);
    starts.emplace_back(std::abs(length - kStartsAway), start);
  }
  std::ranges::stable_sort(starts, {}, &std::pair<double, Start>::first);
  std::vector<Start> sorted;
  for (const auto& [off, start] : starts) sorted.push_back(start);
  return sorted;
}

std::optional<Placement> place_before(const Placement& vehicle, const FreeSpace& space,
                                      std::span<const Disc> traffic) {
  const double heading = heading_of(vehicle.orientation * Vec3(0, 0, 1));
  for (const double turn : {0.0, 0.35, -0.35, 0.7, -0.7, 1.4, -1.4, 2.4, -2.4, kPi}) {
    for (const double away : {7.0, 9.0, 11.0, 13.0}) {
      const Vec3 there = vehicle.position + away * direction_of(wrapped(heading + turn), 0);
      if (!has_room(there, space, traffic)) continue;
      const Vec3 at = space.spots() > 0 ? space.place_of(space.spot_at(there)) : there;
      return Placement{at, axis_angle({0, 1, 0}, heading + 0.5 * kPi)};
    }
  }
  return std::nullopt;
}

namespace {

constexpr double kLeaning = 0.35;  // cosine of the lean beyond which a vehicle is overturned
constexpr double kRoom = 2.5;      // m, around a vehicle
constexpr double kFreeSpeed = 3;   // m/s
constexpr double kAway = 0.9;      // m
constexpr double kGetAway = 1.2;   // s, allowed to a vehicle that was put upright to make progress
constexpr double kLift = 0.35;     // m

bool wants_away(const Vehicle& vehicle) { return std::abs(vehicle.controls.throttle) > Controls::kFull / 5; }

bool is_overturned(const Body& chassis) {
  return (chassis.placement.orientation * Vec3(0, 1, 0)).y < kLeaning;
}

// A vehicle on all its wheels that has not tried both directions only stands in front of something.
bool is_caught(const Vehicle& vehicle) {
  return (vehicle.tried_ahead && vehicle.tried_back) ||
         std::any_of(vehicle.wheels.begin(), vehicle.wheels.end(),
                     [](const Wheel& w) { return w.attached && !w.grounded; });
}

void begin_to_count(const Body& chassis, Vehicle& vehicle) {
  vehicle.stuck_at = chassis.placement.position;
  vehicle.stuck_s = 0;
  vehicle.tried_ahead = vehicle.tried_back = false;
}

void count(const Body& chassis, Vehicle& vehicle) {
  const bool overturned = is_overturned(chassis), wants = wants_away(vehicle);
  const Vec3& place = chassis.placement.position;
  if (!vehicle.stuck_at || glm::distance(place, *vehicle.stuck_at) > kAway) begin_to_count(chassis, vehicle);
  vehicle.overturned_s = overturned ? vehicle.overturned_s + kTick : 0;
  vehicle.stuck_s = std::max(0.0, vehicle.stuck_s + (overturned || wants ? kTick : -kTick));
  vehicle.tried_ahead |= wants && vehicle.controls.throttle > 0;
  vehicle.tried_back |= wants && vehicle.controls.throttle < 0;
  if (!overturned && glm::length(chassis.motion.velocity) > kFreeSpeed)
    vehicle.free_place = chassis.placement;
}

bool is_free(const World& world, const Vehicle& vehicle, const Vec3& place) {
  const Sight sight(world);
  for (const Sight::Near& near : sight.bodies()) {
    const bool in_the_way = !near.body->pinned && !vehicle.has(near.id) && near.radius > 0.5;
    if (in_the_way && glm::distance(near.centre, place) < near.radius + kRoom) return false;
  }
  return true;
}

// A place from which a vehicle can drive: where it last did, or the nearest place with room. A wedged one
// has tried the places nearby.
std::optional<Placement> way_out(const World& world, const Vehicle& vehicle, const FreeSpace& space,
                                 const Placement& from) {
  const bool wedged = vehicle.back_off.wedged;
  const auto serves = [&](const Vec3& place) {
    return glm::distance(place, from.position) > kAway && is_free(world, vehicle, place);
  };
  if (!wedged && vehicle.free_place && serves(vehicle.free_place->position)) return vehicle.free_place;
  if (space.spots() == 0) return std::nullopt;
  constexpr double kFarthest = 20, kApart = 2, kWellAway = 6;  // m
  constexpr int kDirections = 12;
  for (double reach = wedged ? kWellAway : kApart; reach <= kFarthest; reach += kApart) {
    for (int i = 0; i < kDirections; ++i) {
      const Vec3 there = from.position + reach * direction_of(2 * kPi * i / kDirections, 0);
      const FreeSpace::Spot spot = space.spot_at(there);
      if (space.has_room(spot) && serves(space.place_of(spot)))
        return Placement{space.place_of(spot), from.orientation};
    }
  }
  return std::nullopt;
}

}  // namespace

Placement upright(const Placement& placement, double ground) {
  const double heading = heading_of(placement.orientation * Vec3(0, 0, 1));
  Vec3 position = placement.position;
  position.y = std::max(position.y, ground) + kLift;
  return {position, axis_angle({0, 1, 0}, heading)};
}

bool recover_vehicle(World& world, Vehicle& vehicle, const FreeSpace& space, const MatchTimes& times) {
  if (!vehicle.alive || vehicle.wheels_attached() == 0) return false;
  Body& chassis = world.body(vehicle.chassis);
  count(chassis, vehicle);
  const bool overturned = vehicle.overturned_s >= times.righting;
  const bool caught = vehicle.stuck_s >= times.stuck && is_caught(vehicle);
  const bool stuck = (caught || vehicle.back_off.wedged) && vehicle.can_drive();
  if (!overturned && !stuck) return false;
  const double ground = world.environment().ground.value_or(chassis.placement.position.y);
  // The centre of a vehicle on its roof is not at its origin.
  const Vec3 middle = chassis.placement.to_world(chassis.middle());
  const Placement here = upright({{middle.x, overturned ? middle.y : chassis.placement.position.y, middle.z},
                                  chassis.placement.orientation},
                                 ground);
  const std::optional<Placement> out = overturned ? std::nullopt : way_out(world, vehicle, space, here);
  chassis.placement = out ? upright(*out, ground) : here;
  chassis.motion = Motion{};
  vehicle.overturned_s = 0;
  vehicle.back_off = {};
  begin_to_count(chassis, vehicle);
  if (!out) vehicle.stuck_s = std::max(0.0, times.stuck - kGetAway);
  vehicle.gun.last.reset();  // otherwise the beam would sweep through everything in between
  place_carried(world, vehicle);
  return true;
}

}  // namespace kerf
