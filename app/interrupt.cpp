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

bool interrupted() { return interrupt_seen != 0; }

}  // namespace kerf
