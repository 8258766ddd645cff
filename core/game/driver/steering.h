#pragma once

#include <functional>
#include <span>
#include <vector>

#include "core/base/random.h"
#include "core/game/arena/arena.h"
#include "core/game/vehicle/vehicle.h"
#include "core/world/world.h"

namespace kerf {

// A loose body of an arena, or a part of one, as a disc seen from above.
struct Disc {
  Vec3 centre{0};     // m
  double radius = 0;  // m
  Vec3 velocity{0};   // m/s
  BodyId body;
};

// The discs of all bodies that vehicles avoid: chassis, wrecks, props, and large pieces. Long bodies are
// covered by several discs, tall ones only up to the height of vehicles. O(bodies + faces of tall ones).
std::vector<Disc> find_traffic(const World& world, std::span<const Vehicle> vehicles);

struct DriverView {
  const World& world;
  const Sight& sight;
  std::span<const Vehicle> vehicles;
  size_t self = 0;
  std::span<const size_t> opponents;
  std::function<bool(BodyId)> is_wall;  // returns true if a body stops a beam
  Vec2 arena_size{0};                   // m
  double range = 0;                     // m, of lasers
  const FreeSpace& space;
  std::span<const Disc> traffic;  // see find_traffic

  const Vehicle& own() const { return vehicles[self]; }
  const Body& chassis(size_t vehicle) const { return world.body(vehicles[vehicle].chassis); }
};

// Finds a route of a vehicle, as points a cell apart; empty if there is none. It keeps away from fixed
// bodies as far as there is room, and bypasses `traffic` if that is shorter than waiting for it. From a
// start without room it first leads to the nearest spot with room; a goal without room is replaced by the
// nearest spot with room.
//
// A* (P. Hart, N. Nilsson, B. Raphael: A formal basis for the heuristic determination of minimum cost
// paths, 1968). O(spots log spots) in the worst case.
std::vector<Vec3> find_route(const FreeSpace& space, std::span<const Disc> traffic, const Vec3& from,
                             const Vec3& to);

// A vehicle seen from above.
struct Course {
  Vec3 at{0};              // m, midway between the axles
  double heading = 0;      // rad, see direction_of
  double speed = 0;        // m/s, forward
  double wheelbase = 2.6;  // m
  double reach = 1.3;      // m, from the middle to the discs at the front and at the rear
};

// A steering command for the next moment.
struct Arc {
  double steer = 0;  // -1 .. 1, fraction of the full lock, positive to the left
  double speed = 0;  // m/s, target; negative backwards
};

// The predicted end of an arc.
struct ArcEnd {
  Vec3 at{0};
  double heading = 0;
  double free_s = 0, free_m = 0;  // time and distance to an obstacle, or to its end
  double room = 0;                // m, the minimum clearance along it
};

inline constexpr double kArcTime = 1.8;  // s

// Predicts the motion of a vehicle along an arc in the plane (kinematic bicycle) for kArcTime, or until one
// of the three discs that cover it has no room or hits `traffic`, which moves with constant velocity. An
// existing overlap counts only if it becomes deeper. Based on: D. Fox, W. Burgard, S. Thrun: The dynamic
// window approach to collision avoidance, 1997.
ArcEnd follow_arc(const FreeSpace& space, std::span<const Disc> traffic, const Course& course,
                  const Arc& arc);

// Drives a vehicle around an opponent at a distance, past walls and wrecks, and out of places where it is
// stuck.
//
// Every second it plans a route to a place on a circle around the opponent, and every few ticks it selects
// the arc, forward or backward, that follows the route best without a collision (see follow_arc). A vehicle
// that makes no progress for a moment tries the other direction.
class Steering {
 public:
  explicit Steering(uint64_t seed);

  // Sets throttle, steer and handbrake. `at`: the estimated position of the opponent; `distance` [m]: to
  // keep from it; `share`: fraction of its speed to use.
  void drive(const DriverView& view, const Vec3& at, double distance, double share, Controls& controls);

 private:
  Vec3 select_goal(const DriverView& view, const Course& course, const Vec3& at, double distance) const;
  Vec3 point_ahead(const DriverView& view, const Course& course) const;
  void select_arc(const DriverView& view, const Course& course, double share);
  double value_of(const ArcEnd& end, const Course& course, const Arc& arc, const Vec3& target) const;
  void record_progress(const Course& course, const Controls& controls);

  Random random_;
  double side_;              // +1 or -1: direction around the opponent
  int turn_in_ = 0;          // ticks until it may reverse that
  int plan_in_ = 0;          // ticks until it plans a route
  int look_in_ = 0;          // ticks until it selects another arc
  std::vector<Vec3> route_;  // m
  Arc arc_;
  double free_m_ = 0;       // m, along the arc
  Vec3 anchor_{0};          // m, where it last made progress
  int held_ = 0;            // ticks without progress from there
  int escape_ = 0;          // ticks for which it still escapes in one direction
  double escape_gear_ = 1;  // +1 or -1
};

}  // namespace kerf
