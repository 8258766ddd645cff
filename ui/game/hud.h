#pragma once

#include <imgui.h>
#include <deque>
#include <optional>
#include <string>

#include "core/game/match/match.h"
#include "ui/game/player_input.h"
#include "ui/render/view/camera.h"

namespace kerf {

// Describes why a match ended, for the player: "Your engine was cut off by the van". `killer` is the vehicle
// whose beam wrecked the player's car, if one did. Precondition: the match is over.
std::string end_reason(const Match& match, size_t killer = Event::kNobody);

// Display names of parts of a vehicle: "engine", "front left wheel".
const char* name_of_vital(const VehicleDescription& vehicle, size_t vital);
std::string name_of_wheel(const VehicleDescription& vehicle, size_t wheel);

// A line about a recent event, shown for a while.
struct Notice {
  std::string text;
  double points = 0;   // the player's reward; 0: not shown
  int times = 1;       // repetitions in quick succession
  double age = 0;      // s
  bool good = true;    // for the player
  bool large = false;  // in the middle of the screen
};

// The recent events of a match for the HUD.
class HudState {
 public:
  void on_tick(const Match& match);
  // Shows a line that is not an event of the match.
  void note(std::string text) { add_line(std::move(text), 0, true); }
  void advance(double seconds);
  void clear();

  const std::deque<Notice>& notices() const { return notices_; }
  // hurt() falls from 1, when the player was just hit, to 0. hurt_from(): source of that beam [m, world].
  double hurt() const { return hurt_; }
  const Vec3& hurt_from() const { return hurt_from_; }
  // Falls from 1, when the player's beam just cut an enemy, to 0.
  double biting() const { return biting_; }

 private:
  void on_event(const Match& match, const Event& event);
  void add_line(std::string text, double points, bool good, bool large = false);

  std::deque<Notice> notices_;
  double hurt_ = 0, biting_ = 0;
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
  // Returns nullopt when all tasks are done.
  std::optional<Task> task(const Match& match) const;

  // Processes the last tick of the match. Returns true if a task was completed in it.
  bool on_tick(const Match& match);
  bool done() const { return step_ == Step::kDone; }

 private:
  enum class Step { kDrive, kDrum, kWheel, kDone };
  bool is_done(const Match& match);

  Step step_ = Step::kDrive;
  Vec3 place_{0};          // m, destination of the drive
  BodyId drum_;            // invalid if there is nothing to cut
  size_t drum_faces_ = 0;  // faces cut out of the drum
};

// Formats seconds as "2:05"; negative ones as 0:00.
std::string clock_text(double seconds);

// Draws parts of the HUD, in screen coordinates. Text and lines have a dark edge, to be legible on any
// background.
class HudPaint {
 public:
  enum class Align { kLeft, kMiddle, kRight };

  HudPaint();

  float em() const { return em_; }
  ImVec2 size() const { return size_; }
  ImDrawList& list() const { return list_; }

  void text(ImVec2 at, const std::string& text, ImU32 colour, float scale = 1,
            Align align = Align::kLeft) const;
  float width_of(const std::string& text, float scale) const;
  // A bar filled by a fraction, with a label before it.
  void bar(ImVec2 at, float width, const char* name, double share, ImU32 colour, bool striped) const;
  void line(ImVec2 from, ImVec2 to, ImU32 colour, float width) const;
  void circle(ImVec2 at, float radius, ImU32 colour, float width) const;
  void shade(ImVec2 from, ImVec2 to) const;

  // Returns a colour with its opacity multiplied by a factor from 0 to 1.
  static ImU32 faded(ImU32 colour, double opacity);

 private:
  ImDrawList& list_;
  float em_;
  ImVec2 size_;
};

struct HudView {
  const Match& match;
  const HudState& state;
  const CameraView& camera;
  const Sight& sight;        // of the world of the match
  Vec3 aim;                  // the player's aim, unit
  double width = 0;          // of the beam, 0 .. 1
  bool guide = false;        // shows the keys
  std::string machine = {};  // performance of the machine; empty: not shown
  std::optional<SightedPart> sighted = {};
  std::optional<Lesson::Task> task = {};
};

// Draws the HUD of a match over the window with ImGui: reticle, energy and heat, speed, the player's
// vehicle with its damage, score, clock, notices, directions to enemies, and the sighted enemy with its
// damage. Colour is never the only cue. Sizes follow the text size.
void draw_hud(const HudView& view);

}  // namespace kerf
