#include "ui/game/match_clock.h"

#include <algorithm>
#include <cmath>

#include "core/base/assert.h"

namespace kerf {

namespace {

constexpr double kSlow = 0.25;
constexpr double kSpeedSeconds = 0.7;  // over which the speed is averaged

}  // namespace

int MatchClock::advance(double seconds) {
  KERF_ASSERT(seconds >= 0);
  const double slow = std::min(seconds, slow_s_);
  slow_s_ -= slow;
  owed_ += (seconds - slow * (1 - kSlow)) * kTicksPerSecond;
  const int due = static_cast<int>(std::floor(owed_));
  owed_ -= due;
  const int ticks = std::min(due, kMostTicks);
  dropped_ = due - ticks;
  if (due > 0) {
    const double share = 1 - std::exp(-seconds / kSpeedSeconds);
    speed_ += share * (static_cast<double>(ticks) / due - speed_);
  }
  return ticks;
}

}  // namespace kerf
