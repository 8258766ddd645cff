#include "app/progress_line.h"

#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <csignal>
#include <iostream>

namespace kerf {

namespace {

constexpr std::chrono::milliseconds kBetweenUpdates{100};
// Nothing is shown for work that takes less time than this.
constexpr std::chrono::milliseconds kBeforeFirst{200};
constexpr const char* kClearLine = "\r\x1b[K";
constexpr size_t kLongestWork = 60;  // so that the line does not wrap: a wrapped one cannot be overwritten

volatile std::sig_atomic_t interrupt_seen = 0;

}  // namespace

void catch_interrupts() {
  const auto remember = [](int signal) { interrupt_seen = signal; };
  std::signal(SIGINT, remember);
  std::signal(SIGTERM, remember);
}

void let_interrupts_end() {
  const auto end = [](int signal) { ::_exit(kSignalStatus + signal); };
  std::signal(SIGINT, end);
  std::signal(SIGTERM, end);
}

bool interrupted() { return interrupt_seen != 0; }

int interrupt_status() { return interrupted() ? kSignalStatus + interrupt_seen : 0; }

ProgressLine::ProgressLine(std::string work)
    : work_(std::move(work)),
      terminal_(::isatty(STDERR_FILENO) == 1),
      next_(std::chrono::steady_clock::now() + kBeforeFirst) {
  if (work_.size() > kLongestWork) work_ = work_.substr(0, kLongestWork - 3) + "...";
}

ProgressLine::~ProgressLine() {
  if (shown_) std::cerr << kClearLine << std::flush;
}

bool ProgressLine::update(double fraction) {
  if (interrupted()) return false;
  if (!terminal_) return true;
  const auto now = std::chrono::steady_clock::now();
  if (now < next_) return true;
  next_ = now + kBetweenUpdates;
  shown_ = true;
  const int percent = static_cast<int>(std::floor(100 * std::clamp(fraction, 0.0, 1.0)));
  std::cerr << kClearLine << "kerf: " << work_ << ' ' << percent << " %" << std::flush;
  return true;
}

Error stopped() { return failed("stopped before it was done"); }

Error error_or_stopped(const Error& error) { return interrupted() ? stopped() : error; }

}  // namespace kerf
