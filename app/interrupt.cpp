#include "app/interrupt.h"

#include <csignal>

namespace kerf {

namespace {

volatile std::sig_atomic_t interrupt_seen = 0;

}  // namespace

void catch_interrupts() {
  const auto remember = [](int) { interrupt_seen = 1; };
  std::signal(SIGINT, remember);
  std::signal(SIGTERM, remember);
}

void let_interrupts_end() {
  std::signal(SIGINT, SIG_DFL);
  std::signal(SIGTERM, SIG_DFL);
}

bool interrupted() { return interrupt_seen != 0; }

}  // namespace kerf
