#pragma once

#include <deque>
#include <string>

#include "core/game/match/match.h"

namespace kerf {

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

}  // namespace kerf
