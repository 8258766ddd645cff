#pragma once

#include <span>
#include <vector>

#include "core/base/random.h"
#include "core/game/arena/free_space.h"
#include "core/game/driver/driver_view.h"

namespace kerf {

// A way of a vehicle from one place to another, as points a cell apart, or nothing where there is none. It
// stays away from what is fixed as far as there is room, and drives around `traffic` where that is shorter
// than waiting for it. A start without room leads to the nearest spot with room first. The goal is taken to
// the nearest spot with room.
//
// A* (P. Hart, N. Nilsson, B. Raphael: A formal basis for the heuristic determination of minimum cost paths,
// 1968). O(spots log spots) at worst.
std::vector<Vec3> find_route(const FreeSpace& space, std::span<const Disc> traffic, const Vec3& from,
                             const Vec3& to);

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

// Drives a vehicle around an opponent at a distance, past walls and wrecks, and back out of where it got
// stuck.
//
// Every second it finds a route to a place on a circle around the opponent, and every few ticks it takes the
// arc, ahead or backwards, that leads best along the route and meets nothing (see follow_arc). A vehicle that
// does not get away for a moment tries the other direction.
class Steering {
 public:
  explicit Steering(uint64_t seed);

  // Sets throttle, steer and handbrake. `at` is where it believes the opponent to be; it keeps `distance`
  // metres away and uses this share of its speed.
  void drive(const DriverView& view, const Vec3& at, double distance, double share, Controls& controls);

 private:
  Vec3 choose_goal(const DriverView& view, const Course& course, const Vec3& at, double distance) const;
  Vec3 point_ahead(const DriverView& view, const Course& course) const;
  void choose_arc(const DriverView& view, const Course& course, double share);
  double value_of(const ArcEnd& end, const Course& course, const Arc& arc, const Vec3& target) const;
  void record_progress(const Course& course, const Controls& controls);

  Random random_;
  double side_;              // +1 or -1: which way around
  int turn_in_ = 0;          // ticks until it may turn round
  int plan_in_ = 0;          // ticks until it looks for a new route
  int look_in_ = 0;          // ticks until it chooses another arc
  std::vector<Vec3> route_;  // m
  Arc arc_;
  double free_m_ = 0;       // m, along the arc
  Vec3 anchor_{0};          // m, where it was when it last got away
  int held_ = 0;            // ticks for which it did not get away from there
  int escape_ = 0;          // ticks for which it still drives into one direction
  double escape_gear_ = 1;  // +1 or -1
};

}  // namespace kerf
