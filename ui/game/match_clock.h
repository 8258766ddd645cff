#pragma once

#include "core/base/tick.h"

namespace kerf {

// Tells how many ticks of a match a frame has to advance. A frame never advances more than kMostTicks: where
// the machine is too slow for more, the match runs in slow motion.
class MatchClock {
 public:
  static constexpr int kMostTicks = 8;

  // The ticks that are due after a frame of a duration (s, >= 0).
  int advance(double seconds);
  // For some time (s) of the player the match runs at a quarter of its speed.
  void slow_down(double seconds) { slow_s_ = seconds; }
  bool is_slow() const { return slow_s_ > 0; }
  double slow_left() const { return slow_s_; }  // s
  // How many of the ticks that were due were dropped by the last advance().
  int dropped() const { return dropped_; }
  // The share of the ticks that were due in the last second or so and were not dropped: below 1 the machine
  // is too slow.
  double speed() const { return speed_; }

 private:
  double owed_ = 0;    // ticks, below 1
  double slow_s_ = 0;  // left of the slow motion
  int dropped_ = 0;
  double speed_ = 1;
};

}  // namespace kerf
