#pragma once

#include <filesystem>
#include <optional>

#include "core/game/match/match.h"
#include "ui/window/gui_look.h"

namespace kerf {

// How a game is played in a window.
struct GameOptions {
  MatchSetup setup;
  bool chosen_difficulty = false;  // setup.difficulty was asked for; otherwise the settings say it
  GuiLook look;
  bool from_editor = false;
  bool bot = false;                                // a bot plays; the player only watches
  double seconds = 0;                              // after which the game ends by itself; 0: never
  std::optional<std::filesystem::path> landmarks;  // see EditorOptions
};

}  // namespace kerf
