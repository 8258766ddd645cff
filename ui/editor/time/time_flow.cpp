#include "ui/editor/time/time_flow.h"

#include <algorithm>
#include <cmath>

#include "core/world/heat_flow.h"
#include "ui/render/view/frame_space.h"

namespace kerf {

namespace {
constexpr double kMeasured = 0.5;  // s, of one measurement
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

namespace {
constexpr double kMaxLag = 0.1;  // s, max. lag to catch up with
constexpr double kMaxTicks = kMaxLag * kTicksPerSecond;
constexpr double kMaxFrame = 0.1, kRest = 1;  // s, max. time to catch up with, visible and not visible
constexpr double kTintedFrom = 500;           // K; below, there is neither tint nor glow
constexpr double kSeenOnScale = 8;            // K above ambient, a step of the temperature view
}  // namespace

void TimeFlow::advance(double seconds) {
  if (!may_go_on()) return end();
  const Document& document = workspace_.session.document;
  pace_.due += std::min(seconds, kMaxLag) * play_.speed().of_real_time * kTicksPerSecond;
  if (workspace_.changes.is_pending() || document.waiting() > 0) {
    pace_.slow_down();
    return pace_.limit_to(pace_.most);
  }
  pace_.speed_up(kMaxTicks);
  if (!begin()) return;
  const bool single = std::exchange(play_.one_tick, false);
  const auto ticks = single ? Ticks{1} : static_cast<Ticks>(pace_.due);
  if (ticks > 0) queue_ticks(ticks);
  if (single) begun_ = false;  // each single tick is a history entry
}

void TimeFlow::end() {
  pace_.due = 0;
  before_ground_.reset();
  if (!begun_ || workspace_.changes.is_pending() || workspace_.session.document.waiting() > 0) return;
  mark_state(workspace_.session.document, workspace_.session.marks, true);
  begun_ = false;
}

// Ends playback if required.
bool TimeFlow::may_go_on() {
  const size_t position = workspace_.session.document.history().position();
  const bool undone = position < std::exchange(position_, position);
  if (!play_.playing && !play_.one_tick) return false;
  if (workspace_.changes.is_pending()) return true;
  const char* disabled_reason = workspace_.why_time_stands_still();
  if (disabled_reason != nullptr) workspace_.message.info(disabled_reason);
  if (disabled_reason != nullptr || (undone && begun_)) play_.stop();
  return play_.playing || play_.one_tick;
}

// Returns false while something else must be done first.
bool TimeFlow::begin() {
  if (begun_) return true;
  Document& document = workspace_.session.document;
  stand_together(workspace_.world(), workspace_.view);
  const Environment fitting = fitting_environment(document.world(), workspace_.view.frame);
  if (fitting != document.world().environment()) {
    if (document.queue().in_stroke()) return false;
    before_ground_ = document.history().position();
    workspace_.changes.apply(SetEnvironment{fitting});
    return false;
  }
  if (!document.queue().in_stroke()) document.apply(Play{});
  position_ = document.history().position();
  // The user has done nothing in between, so one undo includes the ground.
  if (before_ground_ && position_ == *before_ground_ + 2)
    workspace_.changes.groups().add(*before_ground_, document, "Play", true);
  before_ground_.reset();
  return begun_ = true;
}

void TimeFlow::queue_spring() {
  Document& document = workspace_.session.document;
  if (!spring_ && document.world().spring()) document.apply(ReleaseBody{});
  if (spring_ && document.world().spring() != spring_)
    document.apply(DragBody{spring_->piece, spring_->at, spring_->to});
}

// Queues ticks up to a full minute at most.
void TimeFlow::queue_ticks(Ticks ticks) {
  DocumentSession& session = workspace_.session;
  const Ticks of_minute = session.world().clock() % CommandQueue::kTicksToForget;
  if (of_minute == 0) mark_state(session.document, session.marks, true);
  ticks = std::min(ticks, CommandQueue::kTicksToForget - of_minute);
  pace_.take(ticks);
  queue_spring();
  session.document.apply(AdvanceTime{ticks, true});
}

// Cooling
// --------------------------------------------------------------------------------------------------------

bool Cooling::flows() const {
  const UndoStack& history = workspace_.session.document.history();
  const bool stands = play_.playing || play_.one_tick || workspace_.settings.heat_held ||
                      workspace_.changes.is_pending() || workspace_.why_time_stands_still() != nullptr;
  return !stands && history.position() == history.size() && is_hot(workspace_.world());
}

bool Cooling::is_seen() const {
  const double least = workspace_.view.look.show.heat ? kAmbient + kSeenOnScale : kTintedFrom;
  return workspace_.screen.picture->first().warmest() > least;
}

bool Cooling::moving() const {
  return flows() && (is_seen() || workspace_.screen.clock->seconds() - passed_at_ >= kRest);
}

void Cooling::advance(double seconds) {
  Document& document = workspace_.session.document;
  if (!flows()) {
    pace_.due = 0;
    unseen_ = false;
    return;
  }
  if (document.waiting() > 0) return pace_.slow_down();
  const bool seen = is_seen();
  const double longest = (seen ? kMaxFrame : kRest) * kTicksPerSecond;
  pace_.due = std::min(longest, pace_.due + seconds * kTicksPerSecond);
  unseen_ = false;
  if (!seen && pace_.due < longest) return;
  if (seen) pace_.speed_up(longest);
  if (!seen) pace_.limit_to(longest);
  const auto ticks = static_cast<Ticks>(pace_.due);
  if (ticks == 0) return;
  pace_.take(ticks);
  document.apply(AdvanceTime{ticks, false, true});
  unseen_ = !seen;
  passed_at_ = workspace_.screen.clock->seconds();
}

}  // namespace kerf
