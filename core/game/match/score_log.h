#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "core/game/match/match.h"

namespace kerf {

// A part of a match that lies within one wave.
struct MatchMoment {
  WaveStart start;         // of its wave
  Ticks from = 0, to = 0;  // since the beginning of the match
  size_t vehicle = 0;      // to which most of it happened, an index of Match::vehicles()
  double points = 0;       // that the player got in it
};

// Remembers when the player scored, to find the best moment of a match.
class ScoreLog {
 public:
  static constexpr Ticks kMoment = 10 * kTicksPerSecond;
  static constexpr Ticks kAfterwards = 2 * kTicksPerSecond;  // that it goes on after its last points

  // Takes the events of the last tick. To be called after every tick of the match.
  void hear(const Match& match);

  // The kMoment ticks in which the player got the most points, the first of them if there are several, and
  // ending kAfterwards after the last of these points. Without any points the last ticks of the match.
  // Shorter where the wave or the match is. Nothing if the match has not been ticked. Linear time.
  std::optional<MatchMoment> best() const;

 private:
  struct Scored {
    Ticks tick;
    size_t wave;  // an index of waves_
    size_t vehicle;
    double points;
  };
  MatchMoment around(size_t wave, Ticks last) const;

  std::vector<WaveStart> waves_;
  std::vector<Scored> scored_;
  Ticks ticks_ = 0;
};

// The match with this setup and these controls of its player, as it stands after `ticks` ticks, which are
// those since the beginning of the match with those after its end, or when it is settled. Begins at `start`.
// Nothing if `stop` tells so.
// Precondition: start.standing.ticks <= ticks <= controls.size().
std::unique_ptr<Match> match_at(
    const MatchSetup& setup, const WaveStart& start, std::span<const Controls> controls, Ticks ticks,
    const std::function<bool()>& stop = [] { return false; });

}  // namespace kerf
