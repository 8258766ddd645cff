#include "core/game/match/score_log.h"

#include <algorithm>
#include <map>

#include "core/base/assert.h"

namespace kerf {

void ScoreLog::hear(const Match& match) {
  const Standing& standing = match.standing();
  const WaveStart& start = match.wave_start();
  if (waves_.empty() || waves_.back().standing.ticks != start.standing.ticks) waves_.push_back(start);
  ticks_ = standing.elapsed();
  for (const Event& event : match.events()) {
    if (event.points > 0) scored_.push_back({standing.ticks, waves_.size() - 1, event.vehicle, event.points});
  }
}

// The moment of a wave that ends kAfterwards after `last`, or with the wave.
MatchMoment ScoreLog::around(size_t wave, Ticks last) const {
  const Ticks begins = waves_[wave].standing.ticks;
  const Ticks ends = wave + 1 < waves_.size() ? waves_[wave + 1].standing.ticks - 1 : ticks_;
  MatchMoment moment{waves_[wave]};
  moment.to = std::min(last + kAfterwards, ends);
  moment.from = std::max(begins, moment.to - std::min(moment.to, kMoment));
  return moment;
}

std::optional<MatchMoment> ScoreLog::best() const {
  if (waves_.empty() || ticks_ == 0) return std::nullopt;
  MatchMoment best = around(waves_.size() - 1, ticks_);
  size_t first = 0;
  double sum = 0;
  for (size_t last = 0; last < scored_.size(); ++last) {
    sum += scored_[last].points;
    const MatchMoment moment = around(scored_[last].wave, scored_[last].tick);
    while (scored_[first].wave != scored_[last].wave || scored_[first].tick <= moment.from)
      sum -= scored_[first++].points;
    if (sum <= best.points) continue;
    best = moment;
    best.points = sum;
    std::map<size_t, double> by_vehicle;
    for (size_t i = first; i <= last; ++i) by_vehicle[scored_[i].vehicle] += scored_[i].points;
    best.vehicle = std::max_element(by_vehicle.begin(), by_vehicle.end(), [](const auto& a, const auto& b) {
                     return a.second < b.second;
                   })->first;
  }
  return best;
}

std::unique_ptr<Match> match_at(const MatchSetup& setup, const WaveStart& start,
                                std::span<const Controls> controls, Ticks ticks,
                                const std::function<bool()>& stop) {
  KERF_ASSERT(start.standing.ticks <= ticks && static_cast<size_t>(ticks) <= controls.size());
  auto match = std::make_unique<Match>(setup, start);
  while (match->standing().elapsed() < ticks && !match->settled()) {
    if (stop()) return nullptr;
    match->tick(controls[static_cast<size_t>(match->standing().elapsed())]);
  }
  return match;
}

}  // namespace kerf
