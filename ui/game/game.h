#pragma once

#include <memory>
#include <vector>

#include "ui/game/game_options.h"

namespace kerf {

class FrameLoop;
class Window;
struct WindowOptions;

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

// The same in a window of its own. Fails like open_window(), too, and at a line of its script that is wrong.
Result<GameOutcome> play(const GameOptions& options, const WindowOptions& window);

}  // namespace kerf
