#pragma once

#include <optional>
#include <string>

#include "core/game/match/match.h"

namespace kerf {

// Teaches the game by doing, in a match whose enemy stands still: drive to a place, cut a drum, cut a wheel
// off a car.
class Lesson {
 public:
  // `match` is the one that is played, at its beginning, in an arena where things lie about.
  explicit Lesson(const Match& match);

  // What the player has to do, and where (m, in the world).
  struct Task {
    std::string text;
    Vec3 at{0};
  };
  // Nothing once all is done.
  std::optional<Task> task(const Match& match) const;

  // Looks at what the last tick of the match brought. Returns whether a task was done in it.
  bool hear(const Match& match);
  bool done() const { return step_ == Step::kDone; }

 private:
  enum class Step { kDrive, kDrum, kWheel, kDone };
  bool is_done(const Match& match);

  Step step_ = Step::kDrive;
  Vec3 place_{0};          // m, to drive to
  BodyId drum_;            // not valid where nothing can be cut
  size_t drum_faces_ = 0;  // that were cut out of it
};

}  // namespace kerf
