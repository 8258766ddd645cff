#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/game/match/match.h"
#include "ui/game/game_settings.h"
#include "ui/game/match_picture.h"
#include "ui/render/view/view_options.h"
#include "ui/window/gui_look.h"

namespace kerf {

// Begins a menu at a fraction of the width of the window, centred vertically, at least `min_width` em
// wide. Ends with ImGui::End().
void begin_menu(const char* name, float across, float min_width = 22);

void menu_heading(const char* text, float scale = 1.5f);

// Draws a button as wide as the menu, with the landmark `landmark`. Returns true if it was pressed.
bool menu_button(const char* label, const char* landmark);

// Switches the navigation of menus by NavInputs of ImGui on or off; while it is on, Tab is not ImGui's.
void set_menu_navigation(bool on);

// Returns true if the focus of a menu is visible, because the player moved it.
bool is_menu_navigated();

// Draws a list of scores, best first; nothing for an empty list. `now`: rank of the finished match, from 1;
// 0: none. `fights`: matches of this mode are won or lost.
void draw_scores(const std::vector<HighScore>& scores, const std::string& title, size_t now, bool fights);

enum class MenuChoice {
  kNone,
  kResume,
  kRestart,
  kReplay,
  kInspect,
  kTitle,  // to the menu before a match
  kStart,
  kLesson,
  kOther,   // another mode, arena or car was selected in the menu before a match
  kCancel,  // the question before the choice was declined
  kLeave
};

// The destinations of the menus of a match.
struct LeavingWays {
  bool from_editor = false;  // leaving returns to the editor
  bool starts = false;       // there is a menu before the match
};

// The state that the pause menu shows and changes.
struct MenuView {
  GameSettings& settings;
  GuiLook& look;
  ViewOptions& view;  // its switches are the debug views
  LeavingWays ways;
  std::optional<GameAction>& rebound;  // the action whose next key the menu waits for
};

MenuChoice draw_pause_menu(const MenuView& view);

// Asks whether to restart or leave a match. Returns `choice`, kCancel or kNone.
MenuChoice draw_confirmation(MenuChoice choice, const Match& match);

struct MatchResult {
  bool won = false;
  std::vector<double> medals;  // minimum scores for bronze, silver and gold; empty if there are none
  bool ended = false;          // neither won nor lost, without enemies
  std::string why;             // reason of the end, as a sentence
  HighScore score;
  size_t rank = 0;                // see add_high_score
  std::vector<HighScore> scores;  // for the same rules and difficulty, best first
  size_t wheels_lost = 0, pieces = 0;

  // Returns true if matches of these rules are won or lost by a fight; only those have a difficulty.
  bool fights() const { return !score.difficulty.empty(); }
};

// Describes the course of a match in addition to its score: "2 wrecks, 9 pieces cut, 1 wheel lost, 3:20".
std::string words_on_course(const MatchResult& result);

// Draws the result of a match at the left of the window, next to the replay of its best moment. `replay`:
// its state; nullopt if the match has no such moment.
MenuChoice draw_result(const MatchResult& result, std::optional<MatchReplay::State> replay,
                       const LeavingWays& ways);

// The state that the menu before a match shows and changes.
struct StartView {
  GameSettings& settings;
  const std::vector<HighScore>& scores;  // of the selected mode and level, best first
  bool from_editor = false;
};

// Draws the menu before a match over the window: mode, level, arena, car, the rules for wrecking a car, and
// the best scores. Returns kStart, kLesson, kLeave, or kOther if the mode or the car has changed.
MenuChoice draw_start_menu(const StartView& view);

}  // namespace kerf
