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

// Computes the number of ticks that a frame has to advance, at most kMaxTicks: on a machine too slow for
// more, the match runs in slow motion.
class MatchClock {
 public:
  static constexpr int kMaxTicks = 8;

  // Returns the ticks that are due after a frame of a duration [s], >= 0.
  int advance(double seconds);
  // Runs the match at a quarter of its speed for some time [s] of the player.
  void slow_down(double seconds) { slow_s_ = seconds; }
  bool is_slow() const { return slow_s_ > 0; }
  double slow_left() const { return slow_s_; }  // s
  // Due ticks that the last advance() dropped.
  int dropped() const { return dropped_; }
  // The fraction of due ticks not dropped in about the last second; below 1 the machine is too slow.
  double speed() const { return speed_; }

 private:
  double owed_ = 0;    // ticks, below 1
  double slow_s_ = 0;  // left of the slow motion
  int dropped_ = 0;
  double speed_ = 1;
};

// The replay of a moment of a match. A thread simulates the wave up to the beginning of the moment,
// concurrently with the frames.
class MatchReplay {
 public:
  // `controls` are those of the whole match. Precondition: they extend to the end of the moment.
  MatchReplay(const MatchSetup& setup, const MatchMoment& moment, std::vector<Controls> controls);
  ~MatchReplay();
  MatchReplay(const MatchReplay&) = delete;
  MatchReplay& operator=(const MatchReplay&) = delete;

  enum class State { kPreparing, kPlaying, kOver };
  // Returns the state, after a check whether the preparation is finished. Does not wait.
  State state();

  // The match at the current tick of the replay. Precondition of this and the following functions: state()
  // is not kPreparing.
  const Match& match() const {
    KERF_ASSERT(match_ != nullptr);
    return *match_;
  }
  const ReplayCamera& camera() const { return camera_; }
  // Returns the ticks that are due after a frame of a duration [s]; in slow motion while a vehicle is cut
  // in two.
  int due(double seconds);
  bool is_slow() const { return clock_.is_slow(); }
  // Advances by a tick. No-op once it is over.
  void tick();
  // Ends it: state() returns kOver from now on.
  void skip() { skipped_ = true; }
  void move_camera(double seconds) { camera_.follow(*match_, seconds); }

 private:
  std::vector<Controls> controls_;
  Ticks to_;
  bool skipped_ = false;
  std::atomic<bool> stopped_ = false;
  std::future<std::unique_ptr<Match>> prepared_;
  std::unique_ptr<Match> match_;  // null during preparation
  MatchClock clock_;
  ReplayCamera camera_;
};

}  // namespace kerf
