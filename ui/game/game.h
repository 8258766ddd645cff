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
struct WindowOptions;

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

// A suspended match, which can be resumed.
struct SuspendedMatch {
  std::unique_ptr<Match> match;
  std::vector<Controls> played;  // by tick of the match
};

struct GameOutcome {
  SuspendedMatch last;  // its match is not null
  std::vector<double> frame_seconds;
  bool inspect = false;  // the player wants to inspect the world
  View view;             // of the player
};

// A game in an existing window. It can be left to inspect its world, and resumed.
class WindowedGame {
 public:
  // The window must outlive it. Fails if a shader is missing or does not compile. Begins with the pause
  // menu of a suspended match, if there is one.
  static Result<WindowedGame> begin(Window& window, const GameOptions& options, SuspendedMatch left = {});
  ~WindowedGame();
  WindowedGame(WindowedGame&&) noexcept;
  WindowedGame& operator=(WindowedGame&&) noexcept;

  // Runs the game until the player leaves. Another call resumes it, with the menu that was open.
  void play(FrameLoop& loop);

  bool wants_inspection() const;
  GuiLook look() const;
  const Match& match() const;
  View view() const;
  // Precondition: play() is not called again.
  GameOutcome outcome();

 private:
  explicit WindowedGame(std::unique_ptr<GameScreen> screen);
  std::unique_ptr<GameScreen> screen_;
};

// Plays in its own window. Fails like WindowedGame::begin() and open_window(), and at an invalid line of
// the script.
Result<GameOutcome> play(const GameOptions& options, const WindowOptions& window);

}  // namespace kerf
