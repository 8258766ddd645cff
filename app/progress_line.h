#pragma once

#include <chrono>
#include <string>

#include "core/base/progress.h"
#include "core/base/result.h"

namespace kerf {

// Shows how far long work is and lets Ctrl-C stop it (see catch_interrupts): one line on standard error that
// overwrites itself, "kerf: cutting 42 %", at most ten times a second, and gone when this object is. Where
// standard error is no terminal nothing is shown.
class ProgressLine {
 public:
  explicit ProgressLine(std::string work);
  ~ProgressLine();
  ProgressLine(const ProgressLine&) = delete;
  ProgressLine& operator=(const ProgressLine&) = delete;

  // fraction: 0 to 1. Whether to go on; false once the user has asked to stop.
  bool update(double fraction);
  // The same for work that reports by itself; must not outlive this object.
  Progress progress() {
    return {[this](double fraction) { return update(fraction); }};
  }

 private:
  std::string work_;
  bool terminal_;
  bool shown_ = false;
  std::chrono::steady_clock::time_point next_;
};

// What is said of work that Ctrl-C has stopped, in place of whatever error that made.
Error stopped();
// `error`, or stopped() where that is why there is one.
Error error_or_stopped(const Error& error);

}  // namespace kerf
