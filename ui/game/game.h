#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <vector>

#include "core/game/match/match.h"
#include "ui/window/gui_look.h"

namespace kerf {

class FrameLoop;
class Window;
struct WindowOptions;

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

// What is left of a game that was played in a window.
struct GameOutcome {
  std::unique_ptr<const Match> match;  // the last one, not null
  std::vector<Controls> played;        // in its ticks
  std::vector<double> frame_seconds;
  bool inspect = false;  // the player wants to look at the world
  GuiLook look;          // as the player left it
};

// Writes the world of a game as a scene in a folder beside the high scores, and returns its file. Fails like
// save_world_as_scene.
Result<std::filesystem::path> save_inspected(const Match& match);

// Plays in a window that is open already, until the player leaves. Fails if a shader is missing or does not
// compile.
Result<GameOutcome> play_in(Window& window, FrameLoop& loop, const GameOptions& options);

// Plays in a window of its own. Fails like play_in() and open_window(), and at a line of the script that is
// wrong.
Result<GameOutcome> play(const GameOptions& options, const WindowOptions& window);

}  // namespace kerf
