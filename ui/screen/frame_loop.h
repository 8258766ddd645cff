#pragma once

#include <chrono>

#include "ui/screen/screen.h"
#include "ui/screen/stop_signals.h"
#include "ui/window/gui.h"
#include "ui/window/scripted_window.h"

namespace kerf {

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
