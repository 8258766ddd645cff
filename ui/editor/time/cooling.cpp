#include "ui/editor/time/cooling.h"

#include <algorithm>

#include "core/world/heat_flow.h"

namespace kerf {

namespace {

constexpr double kLongestFrame = 0.1, kRest = 1;  // s, that are made up for in a frame and between rests
constexpr double kTintedFrom = 500;               // K; below, no tint spreads and nothing glows
constexpr double kSeenOnScale = 8;                // K over the ambient, a step of the temperature view

}  // namespace

bool Cooling::flows() const {
  const History& history = on_.work.document.history();
  const bool stands = play_.playing || play_.one_tick || on_.settings.heat_held || on_.changes.is_pending() ||
                      on_.why_time_stands_still() != nullptr;
  return !stands && history.position() == history.size() && is_hot(on_.work.document.world());
}

bool Cooling::is_seen() const {
  const double least = on_.view.look.show.heat ? kAmbient + kSeenOnScale : kTintedFrom;
  return on_.picture->first().warmest() > least;
}

bool Cooling::moving() const { return flows() && (is_seen() || on_.clock->seconds() - passed_at_ >= kRest); }

void Cooling::advance(double seconds) {
  Document& document = on_.work.document;
  if (!flows()) {
    due_ = 0;
    unseen_ = false;
    return;
  }
  if (document.waiting() > 0) {
    most_ = std::max(1.0, 0.5 * most_);
    return;
  }
  const bool seen = is_seen();
  const double longest = (seen ? kLongestFrame : kRest) * kTicksPerSecond;
  due_ = std::min(longest, due_ + seconds * kTicksPerSecond);
  unseen_ = false;
  if (!seen && due_ < longest) return;
  most_ = seen ? std::min(most_ + 1, longest) : longest;
  due_ = std::min(due_, most_);
  const auto ticks = static_cast<Ticks>(due_);
  if (ticks == 0) return;
  due_ -= static_cast<double>(ticks);
  document.apply(Advance{ticks, false, true});
  unseen_ = !seen;
  passed_at_ = on_.clock->seconds();
}

}  // namespace kerf
