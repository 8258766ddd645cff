#pragma once

#include <cstdint>

namespace kerf {

// The clock of a world counts ticks. A tick is 1/120 s: whatever moves or cools in a world by itself does so
// a whole tick at a time.
using Ticks = uint64_t;

inline constexpr Ticks kTicksPerSecond = 120;

// Seconds after the start of the clock at which so many ticks are over. Exact to one rounding up to 2^53
// ticks, more than two million years.
inline double seconds_of_ticks(Ticks ticks) {
  return static_cast<double>(ticks) / static_cast<double>(kTicksPerSecond);
}

}  // namespace kerf
