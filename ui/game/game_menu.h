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
enum class MenuChoice { kNone, kResume, kRestart, kReplay, kInspect, kLeave };

// What the pause menu shows and changes.
struct MenuView {
  GameSettings& settings;
  GuiLook& look;
  ViewOptions& view;         // its switches are the debug views
  bool from_editor = false;  // leaving goes back there
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
MenuChoice draw_result(const MatchResult& result, MatchReplay::State replay, bool from_editor);

}  // namespace kerf
