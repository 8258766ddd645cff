#pragma once

#include <string>

#include "core/game/match/match.h"

namespace kerf {

// What a long match without a window showed.
struct Endurance {
  std::string fault;  // the first that was found, with its tick; empty if there was none
  size_t ticks = 0, most_bodies = 0;
  double median_s = 0, slow_s = 0, longest_s = 0;  // of ticks, by the clock; `slow_s`: the 99th percentile
  uint64_t hash = 0;                               // of the world in the end
};

// Has the bot play a match for so many seconds of its time, or to its end, and looks after each tick whether
// every body is at a finite place within the arena, and every ten seconds whether every vertex is.
Endurance endure(const MatchSetup& setup, double seconds);

}  // namespace kerf
