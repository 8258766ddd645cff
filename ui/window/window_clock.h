#pragma once

namespace kerf {

// A clock in seconds that never runs backwards. What a screen does for a part of a frame, or once in a while,
// is timed by the clock of its window, so that a window that a script drives shows the same in every run.
class WindowClock {
 public:
  virtual ~WindowClock() = default;
  virtual double seconds() const = 0;
};

}  // namespace kerf
