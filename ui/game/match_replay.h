#pragma once

#include <atomic>
#include <future>
#include <memory>
#include <vector>

#include "core/base/assert.h"
#include "core/base/tick.h"
#include "core/game/match/recording.h"
#include "ui/game/game_camera.h"

namespace kerf {

// Tells how many ticks of a match a frame has to advance. A frame never advances more than kMaxTicks: where
// the machine is too slow for more, the match runs in slow motion.
class MatchClock {
 public:
  static constexpr int kMaxTicks = 8;

  // The ticks that are due after a frame of a duration (s, >= 0).
  int advance(double seconds);
  // For some time (s) of the player the match runs at a quarter of its speed.
  void slow_down(double seconds) { slow_s_ = seconds; }
  bool is_slow() const { return slow_s_ > 0; }
  double slow_left() const { return slow_s_; }  // s
  // How many of the ticks that were due were dropped by the last advance().
  int dropped() const { return dropped_; }
  // The share of the ticks that were due in the last second or so and were not dropped: below 1 the machine
  // is too slow.
  double speed() const { return speed_; }

 private:
  double owed_ = 0;    // ticks, below 1
  double slow_s_ = 0;  // left of the slow motion
  int dropped_ = 0;
  double speed_ = 1;
};

// A moment of a match that is played again. A thread of its own plays the wave up to where the moment begins,
// beside the frames.
class MatchReplay {
 public:
  // `controls` are those of the whole match. Precondition: they reach to the end of the moment.
  MatchReplay(const MatchSetup& setup, const MatchMoment& moment, std::vector<Controls> controls);
  ~MatchReplay();
  MatchReplay(const MatchReplay&) = delete;
  MatchReplay& operator=(const MatchReplay&) = delete;

  enum class State { kPreparing, kPlaying, kOver };
  // Looks whether it can begin. Does not wait.
  State state();

  // The match where the replay is. Precondition of this and of what follows: it is not in preparation.
  const Match& match() const {
    KERF_ASSERT(match_ != nullptr);
    return *match_;
  }
  const ReplayCamera& camera() const { return camera_; }
  // The ticks that are due after a frame of a duration (s); they are in slow motion where a vehicle falls in
  // two.
  int due(double seconds);
  bool is_slow() const { return clock_.is_slow(); }
  // Advances by a tick. Does nothing once it is over.
  void tick();
  // Ends it: state() is kOver from now on.
  void skip() { skipped_ = true; }
  void move_camera(double seconds) { camera_.follow(*match_, seconds); }

 private:
  std::vector<Controls> controls_;
  Ticks to_;
  bool skipped_ = false;
  std::atomic<bool> stopped_ = false;
  std::future<std::unique_ptr<Match>> prepared_;
  std::unique_ptr<Match> match_;  // null while it is prepared
  MatchClock clock_;
  ReplayCamera camera_;
};

}  // namespace kerf
