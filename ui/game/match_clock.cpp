#include "ui/game/match_clock.h"

#include <algorithm>
#include <cmath>

#include "core/base/assert.h"

namespace kerf {

namespace {

constexpr double kSlow = 0.25;

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
  return ticks;
}

}  // namespace kerf
