#include "app/match_report.h"

#include <algorithm>

#include "core/document/text/hash_text.h"
#include "core/game/match/recording.h"
#include "core/world/state_hash.h"

namespace kerf {

namespace {

// In ms, of durations in s.
nlohmann::ordered_json times_of(std::vector<double> seconds) {
  std::sort(seconds.begin(), seconds.end());
  const auto at = [&](double share) {
    const auto i = static_cast<size_t>(share * static_cast<double>(seconds.size()));
    return seconds.empty() ? 0.0 : 1000 * seconds[std::min(i, seconds.size() - 1)];
  };
  return {{"p50", at(0.5)}, {"p99", at(0.99)}, {"max", at(1)}};
}

}  // namespace

const char* result_of(const Match& match) {
  switch (match.standing().phase) {
    case Standing::Phase::kWon:
      return "won";
    case Standing::Phase::kLost:
      return "lost";
    default:
      return "quit";
  }
}

nlohmann::ordered_json match_report(const Match& match, const std::vector<double>& frame_s,
                                    const std::vector<double>& tick_s) {
  const Standing& standing = match.standing();
  return {{"frames", frame_s.size()},
          {"frame_ms", times_of(frame_s)},
          {"ticks", standing.ticks},
          {"tick_ms", times_of(tick_s)},
          {"strokes", match.strokes()},
          {"faces", match.world().live_faces()},
          {"faces_removed", standing.faces_removed},
          {"pieces", standing.pieces},
          {"bodies", match.world().ids().size()},
          {"undo_depth", 0},
          {"score", standing.score},
          {"enemies_destroyed", standing.enemies_destroyed},
          {"wheels_lost", standing.wheels_lost},
          {"wave", standing.wave + 1},
          {"waves", match.rules().waves.size()},
          {"seconds", seconds_of_ticks(standing.ticks)},
          {"seed", match.setup().seed},
          {"difficulty", name_of(match.setup().difficulty)},
          {"result", result_of(match)},
          {"state_hash", hash_text(state_hash(match.world()))}};
}

}  // namespace kerf
