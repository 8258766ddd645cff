#pragma once

#include <optional>

#include "core/base/tick.h"

namespace kerf {

// How fast time passes for the bodies, as it was reached lately: in seconds of the world a second. Where cuts
// or ticks take longer than real time, that is less than the speed that the user has chosen.
class ReachedSpeed {
 public:
  // To be called once a frame; `seconds` have passed since the last call, and `clock` is that of the world.
  void follow(bool playing, Ticks clock, double seconds);
  // Over the last half second; nothing before that is over.
  std::optional<double> of_real_time() const { return reached_; }

 private:
  bool playing_ = false;
  Ticks from_ = 0;      // the clock when the measurement began
  double seconds_ = 0;  // since then
  std::optional<double> reached_;
};

}  // namespace kerf
