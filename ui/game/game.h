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

// How a game is played in a window.
struct GameOptions {
  MatchSetup setup;
  bool chosen_difficulty = false;  // setup.difficulty was asked for; otherwise the settings say it
  GuiLook look;
  bool from_editor = false;
  bool starts = false;                             // with the menu in which mode, level and car are chosen
  bool bot = false;                                // a bot plays; the player only watches
  double seconds = 0;                              // after which the game ends by itself; 0: never
  std::optional<std::filesystem::path> landmarks;  // see EditorOptions
};

// A match that was left and can be gone on with.
struct LeftMatch {
  std::unique_ptr<Match> match;
  std::vector<Controls> played;  // in its ticks
};

// What is left of a game that was played in a window.
struct GameOutcome {
  LeftMatch last;  // its match is not null
  std::vector<double> frame_seconds;
  bool inspect = false;  // the player wants to look at the world
  View view;             // of the player
};

// A game in a window that is open already. It may be left for a look at its world and gone on with.
class WindowedGame {
 public:
  // The window must outlive it. Fails if a shader is missing or does not compile. Begins with the menu of a
  // match that was left, if there is one.
  static Result<WindowedGame> begin(Window& window, const GameOptions& options, LeftMatch left = {});
  ~WindowedGame();
  WindowedGame(WindowedGame&&) noexcept;
  WindowedGame& operator=(WindowedGame&&) noexcept;

  // Plays until the player leaves. Another call goes on from there, with the menu that was open.
  void play(FrameLoop& loop);

  // How it was left.
  bool wants_inspection() const;
  GuiLook look() const;
  const Match& match() const;
  View view() const;
  // Precondition: it is not played any more.
  GameOutcome outcome();

 private:
  explicit WindowedGame(std::unique_ptr<GameScreen> screen);
  std::unique_ptr<GameScreen> screen_;
};

// Plays in a window of its own. Fails like play_in() and open_window(), and at a line of the script that is
// wrong.
Result<GameOutcome> play(const GameOptions& options, const WindowOptions& window);

}  // namespace kerf
