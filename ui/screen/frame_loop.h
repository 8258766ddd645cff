#pragma once

#include <chrono>

#include "ui/screen/screen.h"
#include "ui/window/gui.h"
#include "ui/window/stop_signals.h"

namespace kerf {

// Runs screens in a window: waits until there is something to draw, hands on what the user did, and shows
// frame after frame, sixty a second at most.
class FrameLoop {
 public:
  // Both must outlive it.
  FrameLoop(Window& window, Gui& gui) : window_(window), gui_(gui) {}

  // Runs until the screen is over, or SIGINT or SIGTERM came. Returns false where a signal ended it.
  bool run(Screen& screen);

 private:
  using Clock = std::chrono::steady_clock;

  void wait(Screen& screen);
  void frame(Screen& screen);
  Input take_input();

  Window& window_;
  Gui& gui_;
  StopSignals stop_;
  Clock::time_point frame_began_ = Clock::now(), last_event_ = Clock::now();
};

}  // namespace kerf
