#pragma once

#include <optional>

#include "core/game/match/match.h"

namespace kerf {

// Parts that came off, those of them that moved by 5 cm in time, and those that did not since something
// touched them.
struct MovedParts {
  size_t all = 0, moved = 0, held = 0;

  MovedParts& operator+=(const MovedParts& other) {
    all += other.all;
    moved += other.moved;
    held += other.held;
    return *this;
  }
};

// How a match without a window went.
struct MatchCourse {
  bool won = false, lost = false;  // neither: it was ended before
  double seconds = 0;
  double score = 0;
  size_t enemies_destroyed = 0, wave = 0;
  std::optional<double> first_beam, first_part;  // s: of the player, and that came off an enemy
  std::optional<double> first_cut;               // s: of an enemy by the player
  std::optional<double> first_hit, first_death;  // s: of the player's first car
  MovedParts parts, heavy_parts;                 // up to 300 kg, within 0.3 s; heavier ones, within 2 s
  size_t kills_at_once = 0;        // the most vehicles that lost a vital part in a tick by different beams
  double longest_without_way = 0;  // s, for which the player wanted to drive and got nowhere
};

// Returns true if the player's first car was not wrecked within this time [s] of the first hit.
bool outlives(const MatchCourse& course, double seconds);

// Who holds the controls of the player.
enum class MatchDriver { kBot, kStill };

// Plays a match to its end, or for so many seconds of its time.
MatchCourse play_course(const MatchSetup& setup, MatchDriver driver, double seconds);

}  // namespace kerf
