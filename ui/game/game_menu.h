#pragma once

#include <string>
#include <vector>

#include "core/game/match/match.h"
#include "ui/game/game_settings.h"
#include "ui/game/match_replay.h"
#include "ui/render/view/view_options.h"
#include "ui/window/gui_look.h"

namespace kerf {

// What the menus of the game are made of.

// Begins a menu at a share of the width of the window, in the middle of its height, at least so many times as
// wide as the text is high. Ends with ImGui::End().
void begin_menu(const char* name, float across, float least_width = 22);

void menu_heading(const char* text, float scale = 1.5f);

// Draws a button as wide as the menu, named `landmark` among the landmarks. Returns whether it was pressed.
bool menu_button(const char* label, const char* landmark);

// Draws a list of scores, best first, of which the one with the rank `now`, from 1, is of the match that is
// over (0: none is). Nothing where there are none. `fights`: whether such matches are won or lost.
void draw_scores(const std::vector<HighScore>& scores, const std::string& title, size_t now, bool fights);

// What the player chose in a menu.
enum class MenuChoice {
  kNone,
  kResume,
  kRestart,
  kReplay,
  kInspect,
  kTitle,  // to the menu before a match
  kStart,
  kLesson,
  kOther,  // the menu before a match shows another mode or car
  kLeave
};

// Where the menus of a match lead.
struct LeavingWays {
  bool from_editor = false;  // leaving goes back there
  bool starts = false;       // there is a menu before the match
};

// What the pause menu shows and changes.
struct MenuView {
  GameSettings& settings;
  GuiLook& look;
  ViewOptions& view;  // its switches are the debug views
  LeavingWays ways;
};

// Draws the menu of a match that is paused over the window.
MenuChoice draw_pause_menu(const MenuView& view);

// How a match ended.
struct MatchResult {
  bool won = false;
  bool ended = false;  // neither won nor lost: nobody was there to fight
  std::string why;     // why it ended, in words
  HighScore score;
  size_t rank = 0;                // see add_high_score
  std::vector<HighScore> scores;  // of the same rules and difficulty, best first
  size_t wheels_lost = 0, pieces = 0;
};

// Draws the result of a match at the left of the window, beside the replay of its best moment.
MenuChoice draw_result(const MatchResult& result, MatchReplay::State replay, const LeavingWays& ways);

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
