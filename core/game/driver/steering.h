#pragma once

#include "core/base/random.h"
#include "core/game/driver/driver_view.h"

namespace kerf {

// Drives a vehicle around an opponent at a distance, past walls and wrecks, and back out of where it got
// stuck.
//
// Looks along a few directions ahead and takes the one that is clear and nearest to where it wants to go
// (C. Reynolds: Steering behaviors for autonomous characters, 1999).
class Steering {
 public:
  explicit Steering(uint64_t seed) : random_(seed), side_(random_.unit() < 0.5 ? -1 : 1) {}

  // Sets throttle, steer and handbrake. `at` is where it believes the opponent to be; it keeps `distance`
  // metres away and uses this share of the throttle.
  void drive(const DriverView& view, const Vec3& at, double distance, double share, Controls& controls);

 private:
  double wanted_heading(const DriverView& view, const Vec3& at, double distance);
  double clear_length(const DriverView& view, double heading, double length) const;
  double choose_heading(const DriverView& view, double wanted, double reach);
  bool back_out(double speed, Controls& controls);

  Random random_;
  double side_;         // +1 or -1: which way around
  int turn_in_ = 0;     // ticks until it may turn round
  int look_in_ = 0;     // ticks until it looks ahead again
  double heading_ = 0;  // rad, chosen when it looked
  double clear_ = 0;    // m, in that direction
  int blocked_ = 0;     // ticks for which it did not get away
  int reverse_ = 0;     // ticks for which it still backs out
  int detour_ = 0;      // ticks for which it tries another way after that
};

}  // namespace kerf
