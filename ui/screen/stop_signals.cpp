#include "ui/screen/stop_signals.h"

#include <csignal>

#include "core/base/assert.h"

namespace kerf {

namespace {

volatile std::sig_atomic_t stop_received = 0;  // a global, because a signal handler can access nothing else
void remember(int signal) { stop_received = signal; }

}  // namespace

StopSignals::StopSignals()
    : old_interrupt_(std::signal(SIGINT, remember)), old_terminate_(std::signal(SIGTERM, remember)) {
  KERF_ASSERT(old_interrupt_ != remember && old_terminate_ != remember);
  stop_received = 0;
}

StopSignals::~StopSignals() {
  std::signal(SIGINT, old_interrupt_);
  std::signal(SIGTERM, old_terminate_);
}

bool StopSignals::received() const { return stop_received != 0; }

int StopSignals::last() { return stop_received; }

}  // namespace kerf
