#pragma once

#include <vector>

#include "core/base/random.h"
#include "core/game/driver/arc.h"
#include "core/game/driver/driver_view.h"

namespace kerf {

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
  void note_progress(const Course& course, const Controls& controls);

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
