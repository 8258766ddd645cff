#include "ui/editor/time/reached_speed.h"

namespace kerf {

namespace {
constexpr double kMeasured = 0.5;  // s
}

void ReachedSpeed::follow(bool playing, Ticks clock, double seconds) {
  if (!playing || !playing_ || clock < from_) {
    *this = ReachedSpeed();
    playing_ = playing;
    from_ = clock;
    return;
  }
  seconds_ += seconds;
  if (seconds_ < kMeasured) return;
  reached_ = seconds_of_ticks(clock - from_) / seconds_;
  from_ = clock;
  seconds_ = 0;
}

}  // namespace kerf
