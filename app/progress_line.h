#pragma once

#include <chrono>
#include <string>

#include "core/base/progress.h"
#include "core/base/result.h"

namespace kerf {

// What shells add to the number of a signal that ended a program: 130 for Ctrl-C, 143 for SIGTERM.
inline constexpr int kSignalStatus = 128;

// From this call on Ctrl-C and SIGTERM set a flag instead of ending the program. Long computations check the
// flag and stop.
void catch_interrupts();
// Whether the flag is set.
bool interrupted();
// The exit status of a program that such a signal ended, 130 or 143; 0 where the flag is not set.
int interrupt_status();
// From this call on both signals end the program at once with that status, for work that does not check the
// flag.
void let_interrupts_end();

// Shows the progress of a long computation and lets Ctrl-C stop it (see catch_interrupts). It is one line on
// standard error, "kerf: cutting 42 %", that is overwritten at most ten times a second and erased by the
// destructor. Nothing is shown if standard error is not a terminal.
class ProgressLine {
 public:
  // `work` is what the line says: "cutting".
  explicit ProgressLine(std::string work);
  ~ProgressLine();
  ProgressLine(const ProgressLine&) = delete;
  ProgressLine& operator=(const ProgressLine&) = delete;

  // Shows a fraction from 0 to 1. Returns whether to go on, i.e. false after Ctrl-C.
  bool update(double fraction);
  // Makes a Progress that calls update(). It must not outlive this object.
  Progress progress() {
    return {[this](double fraction) { return update(fraction); }};
  }

 private:
  std::string work_;
  bool terminal_;
  bool shown_ = false;
  std::chrono::steady_clock::time_point next_;
};

// The error that is reported after Ctrl-C, in place of the one that stopping caused.
Error stopped();
// stopped() after Ctrl-C, else `error`.
Error error_or_stopped(const Error& error);

}  // namespace kerf
