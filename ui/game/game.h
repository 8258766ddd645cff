#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <vector>

#include "core/document/scene.h"
#include "core/game/match/match.h"
#include "ui/window/gui_look.h"

namespace kerf {

class FrameLoop;
class GameScreen;
class Window;

struct GameOptions {
  MatchSetup setup;
  bool selected_difficulty = false;  // setup.difficulty was requested; otherwise the settings determine it
  GuiLook look;
  bool from_editor = false;
  bool starts = false;                             // begins with the menu for mode, level and car
  bool bot = false;                                // a bot plays; the player only watches
  double seconds = 0;                              // end of the game; 0: never
  std::optional<std::filesystem::path> landmarks;  // see EditorOptions
};

// A game in an existing window. It can be left to inspect its world, and resumed.
class WindowedGame {
 public:
  // The window must outlive it. Fails if a shader is missing or does not compile.
  static Result<WindowedGame> begin(Window& window, const GameOptions& options);
  ~WindowedGame();
  WindowedGame(WindowedGame&&) noexcept;
  WindowedGame& operator=(WindowedGame&&) noexcept;

  // Runs the game until the player leaves. Another call resumes it with everything that was on the screen:
  // the match, its pause menu or its result.
  void play(FrameLoop& loop);

  bool wants_inspection() const;
  // Returns true if the user closed the window.
  bool wants_close() const;
  GuiLook look() const;
  // Replaces the look of a game that is not running.
  void set_look(const GuiLook& look);
  const Match& match() const;
  View view() const;
  // The controls of every tick since the match began.
  const std::vector<Controls>& played() const;
  // The durations of all frames [s].
  const std::vector<double>& frame_seconds() const;

 private:
  explicit WindowedGame(std::unique_ptr<GameScreen> screen);
  std::unique_ptr<GameScreen> screen_;
};

}  // namespace kerf
