#include "ui/game/match_replay.h"

#include <algorithm>
#include <cmath>

#include "core/base/assert.h"

namespace kerf {

namespace {

constexpr double kSlow = 0.25;
constexpr double kSpeedSeconds = 0.7;  // averaging time of the speed

}  // namespace

int MatchClock::advance(double seconds) {
  KERF_ASSERT(seconds >= 0);
  const double slow = std::min(seconds, slow_s_);
  slow_s_ -= slow;
  owed_ += (seconds - slow * (1 - kSlow)) * kTicksPerSecond;
  const int due = static_cast<int>(std::floor(owed_));
  owed_ -= due;
  const int ticks = std::min(due, kMaxTicks);
  dropped_ = due - ticks;
  if (due > 0) {
    const double share = 1 - std::exp(-seconds / kSpeedSeconds);
    speed_ += share * (static_cast<double>(ticks) / due - speed_);
  }
  return ticks;
}

namespace {

constexpr double kSlowMotionInReplay = 1.2;  // s
constexpr double kSlowEnd = 3;               // s, after the end of the match

}  // namespace

MatchReplay::MatchReplay(const MatchSetup& setup, const MatchMoment& moment, std::vector<Controls> controls)
    : controls_(std::move(controls)), to_(moment.to), camera_(moment.vehicle) {
  KERF_ASSERT(moment.from <= moment.to && moment.to <= controls_.size());
  prepared_ = std::async(std::launch::async, [this, setup, moment] {
    return match_at(setup, moment.start, controls_, moment.from, [this] { return stopped_.load(); });
  });
}

MatchReplay::~MatchReplay() { stopped_ = true; }

MatchReplay::State MatchReplay::state() {
  if (!match_) {
    if (prepared_.wait_for(std::chrono::seconds(0)) != std::future_status::ready) return State::kPreparing;
    match_ = prepared_.get();
  }
  const bool over = skipped_ || match_->standing().elapsed() >= to_ || match_->settled();
  return over ? State::kOver : State::kPlaying;
}

int MatchReplay::due(double seconds) { return clock_.advance(seconds); }

void MatchReplay::tick() {
  KERF_ASSERT(match_);
  if (state() == State::kOver) return;
  const bool was_over = match_->standing().over();
  match_->tick(controls_[static_cast<size_t>(match_->standing().elapsed())]);
  if (!was_over && match_->standing().over()) clock_.slow_down(kSlowEnd);
  for (const Event& event : match_->events()) {
    const bool enemy = event.vehicle != Match::kPlayer;
    if (event.kind == Event::Kind::kInHalves && enemy) clock_.slow_down(kSlowMotionInReplay);
  }
}

}  // namespace kerf
