#pragma once

#include <vector>

#include "ui/game/game_menu.h"

namespace kerf {

// What the menu before a match shows and changes.
struct StartView {
  GameSettings& settings;
  const std::vector<HighScore>& scores;  // of the chosen mode and level, best first
  bool from_editor = false;
};

// Draws the menu before a match over the window: what is played, how hard, with which car, what puts a car
// out of action, and the best scores. Its choices are kStart, kLesson, kLeave, and kOther where the mode or
// the car is another one now.
MenuChoice draw_start_menu(const StartView& view);

}  // namespace kerf
