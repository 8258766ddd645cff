#pragma once

#include <chrono>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "ui/screen/stop_signals.h"
#include "ui/window/gui.h"
#include "ui/window/gui_look.h"
#include "ui/window/scripted_window.h"
#include "ui/window/window.h"

namespace kerf {

// User input since the last frame.
struct Input {
  std::vector<InputEvent> events;
  std::vector<std::filesystem::path> drops;  // files dropped on the window
  bool close = false;                        // the user asked to close the window
};

// The duration of a frame [s].
struct FrameTime {
  double whole = 0;   // excluding the wait before it
  double before = 0;  // from its beginning until its handover to the display
};

// The content of the window, such as the editor or a game. FrameLoop calls these functions once per frame
// in this order.
class Screen {
 public:
  virtual ~Screen() = default;

  // Keys and characters held back from the next frame.
  virtual KeyboardHold keyboard_hold() const { return KeyboardHold::kNone; }
  virtual GuiLook look() const = 0;
  virtual void handle_input(const Input& input) = 0;
  // Advances everything that moves or waits, for at most the duration of a frame.
  virtual void advance() = 0;
  // Draws the viewport to the window, and the panels with ImGui.
  virtual void draw() = 0;
  // Called after the viewport and the panels are drawn, before they are displayed.
  virtual void drawn() {}
  virtual void took(const FrameTime&) {}

  // Returns true if the next frame starts immediately rather than at the next event.
  virtual bool moving() const = 0;
  // The minimum duration of a frame without input [s]: positive if only the progress of background work
  // changes, which needs the processors more than the display does.
  virtual double min_frame_seconds() const { return 0; }
  // Called before waiting for an event while nothing moves.
  virtual void rest() {}
  virtual bool over() const = 0;

  // Returns the answer to a query of the script that drives the window, as JSON; nullopt for an unknown
  // query (see EventScript::Answer).
  virtual std::optional<std::string> answer(const std::string&) const { return std::nullopt; }
};

// Runs screens in a window: waits until a frame is needed, forwards user input, and presents frames, at
// most sixty per second or as a script requests them.
class FrameLoop {
 public:
  // The window and the GUI must outlive the loop.
  FrameLoop(Window& window, Gui& gui) : window_(window), gui_(gui) {}

  // Runs until the screen is over, SIGINT or SIGTERM arrives, or the script that drives the window ends.
  // Returns true if the screen is over.
  bool run(Screen& screen);
  // The error in the script, or empty.
  const std::string& fault() const { return fault_; }

 private:
  using Clock = std::chrono::steady_clock;

  bool wait(Screen& screen);
  bool follow(EventScript& script, Screen& screen);
  void frame(Screen& screen);
  Input take_input(const Screen& screen);

  Window& window_;
  Gui& gui_;
  StopSignals stop_;
  std::string fault_;
  Clock::time_point frame_began_ = Clock::now(), last_event_ = Clock::now();
};

}  // namespace kerf
