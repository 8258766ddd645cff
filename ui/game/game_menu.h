#pragma once

#include <vector>

#include "core/game/match/match.h"
#include "ui/game/game_settings.h"
#include "ui/game/high_scores.h"
#include "ui/game/match_replay.h"
#include "ui/render/view/view_options.h"
#include "ui/window/gui_look.h"

namespace kerf {

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

}  // namespace kerf
