#pragma once

#include <deque>
#include <optional>
#include <string>

#include "core/game/match/match.h"
#include "ui/game/game_actions.h"

namespace kerf {

// Describes why a match ended, for the player: "Your engine was cut off by the van". `killer` is the vehicle
// whose beam wrecked the player's car, if one did. Precondition: the match is over.
std::string end_reason(const Match& match, size_t killer = Event::kNobody);

// Describes what giving up does to a player whose car has no laser; empty if it does nothing. `control`: the
// name of the key or button.
std::string give_up_hint(const Match& match, const std::string& control);

// Describes what leaving an unfinished match discards: "Wave 2 and 450 points will be lost."
std::string loss_warning(const Match& match);

// Display names of parts of a vehicle: "engine", "front left wheel".
const char* name_of_vital(const VehicleDescription& vehicle, size_t vital);
std::string name_of_wheel(const VehicleDescription& vehicle, size_t wheel);
inline constexpr const char* kTankName = "fuel tank";

// A line about a recent event, shown for a while.
struct Notice {
  std::string text;
  double points = 0;   // the player's reward; 0: not shown
  int times = 1;       // repetitions in quick succession
  double age = 0;      // s
  bool good = true;    // for the player
  bool large = false;  // in the middle of the screen
};

// Points that fly up from the place where they were won.
struct FlyingPoints {
  Vec3 at{0};  // m, world
  double points = 0;
  size_t combo = 1;  // their factor, included
  double age = 0;    // s
  static constexpr double kSeconds = 1.1;
};

// The recent events of a match for the HUD.
class HudState {
 public:
  void on_tick(const Match& match);
  // Shows a line that is not an event of the match.
  void note(std::string text) { add_line(std::move(text), 0, true); }
  void advance(double seconds);
  void clear();

  // Newest first.
  const std::deque<Notice>& notices() const { return notices_; }
  const std::deque<FlyingPoints>& points() const { return points_; }
  // Sum of the times by which the events were advanced [s].
  double clock() const { return clock_; }
  // hurt() falls from 1, when the player was just hit, to 0. hurt_from(): source of that beam [m, world].
  double hurt() const { return hurt_; }
  const Vec3& hurt_from() const { return hurt_from_; }
  // Falls from 1, when the player's beam just cut an enemy, to 0.
  double biting() const { return biting_; }

 private:
  void on_event(const Match& match, const Event& event);
  void add_points(const Event& event);
  void add_line(std::string text, double points, bool good, bool large = false);

  std::deque<Notice> notices_;
  std::deque<FlyingPoints> points_;
  double hurt_ = 0, biting_ = 0, clock_ = 0;
  Vec3 hurt_from_{0};
};

// An interactive tutorial in a match with a stationary enemy: drive to a place, cut a drum, cut a wheel off
// a car.
class Lesson {
 public:
  // Precondition: `match`, the one that the user plays, has just begun, and its arena has loose objects.
  explicit Lesson(const Match& match);

  // The player's task and its place (m, in the world).
  struct Task {
    std::string text;
    Vec3 at{0};
  };
  // Returns nullopt when all tasks are done. The text names keys, or the parts of a gamepad.
  std::optional<Task> task(const Match& match, const KeyBindings& keys = default_bindings(),
                           bool gamepad = false) const;

  // Processes the last tick of the match. Returns true if a task was completed in it.
  bool on_tick(const Match& match);
  bool done() const { return step_ == Step::kDone; }

 private:
  enum class Step { kDrive, kDrum, kWheel, kDone };
  bool is_done(const Match& match);

  Step step_ = Step::kDrive;
  Vec3 place_{0};          // m, destination of the drive
  BodyId drum_;            // invalid if there is nothing to cut
  double drum_removed_ = 0;  // kg, cut out of the drum
};

// Formats seconds as "2:05"; negative ones as 0:00.
std::string clock_text(double seconds);

}  // namespace kerf
