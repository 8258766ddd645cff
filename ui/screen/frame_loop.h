#pragma once

#include <chrono>

#include "ui/screen/screen.h"
#include "ui/window/gui.h"
#include "ui/window/stop_signals.h"

namespace kerf {

// Runs screens in a window: waits until there is something to draw, passes user input on, and shows frames,
// at most sixty per second.
class FrameLoop {
 public:
  // Both must outlive it.
  FrameLoop(Window& window, Gui& gui) : window_(window), gui_(gui) {}

  // Runs until the screen is over or SIGINT or SIGTERM arrives. Returns false if a signal ended it.
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
