#pragma once

#include <cstdint>

namespace kerf {

// The clock of a world counts ticks of 1/120 s. Motion and cooling in a world advance by whole ticks.
using Ticks = uint64_t;

inline constexpr Ticks kTicksPerSecond = 120;
inline constexpr double kTick = 1.0 / kTicksPerSecond;  // s

// Converts ticks to seconds, correctly rounded up to 2^53 ticks, i.e. more than two million years.
inline double seconds_of_ticks(Ticks ticks) {
  return static_cast<double>(ticks) / static_cast<double>(kTicksPerSecond);
}

}  // namespace kerf
