#pragma once

#include <deque>
#include <optional>
#include <string>

#include "core/game/match/match.h"

namespace kerf {

// Why a match ended, for the player: "Your engine was cut off by the van". `killer` is the vehicle whose beam
// put the player's car out, where one did. Precondition: it is over.
std::string why_it_ended(const Match& match, size_t killer = Event::kNobody);

// What parts of a vehicle are called: "engine", "front left wheel".
const char* name_of_vital(const VehicleDescription& vehicle, size_t vital);
std::string name_of_wheel(const VehicleDescription& vehicle, size_t wheel);

// A line of what just happened, shown for a while.
struct Notice {
  std::string text;
  double points = 0;   // that the player got; 0: none are shown
  int times = 1;       // how often it happened shortly one after the other
  double age = 0;      // s
  bool good = true;    // for the player
  bool large = false;  // in the middle of the picture
};

// What the screen of a match remembers of its events.
class HudState {
 public:
  // Takes the events of the last tick.
  void hear(const Match& match);
  // Shows a line that has nothing to do with the match.
  void note(std::string text) { say(std::move(text), 0, true); }
  void advance(double seconds);
  void clear();

  const std::deque<Notice>& notices() const { return notices_; }
  // From 1, when the player was just hit, to 0; and where the beam came from (world, m).
  double hurt() const { return hurt_; }
  const Vec3& hurt_from() const { return hurt_from_; }
  // From 1, when the player's beam just cut an enemy, to 0.
  double biting() const { return biting_; }

 private:
  void tell(const Match& match, const Event& event);
  void say(std::string text, double points, bool good, bool large = false);

  std::deque<Notice> notices_;
  double hurt_ = 0, biting_ = 0;
  Vec3 hurt_from_{0};
};

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
