#include "ui/editor/changes/time_flow.h"

#include <algorithm>
#include <cmath>

#include "ui/render/drawn_ground.h"
#include "ui/render/spread.h"

namespace kerf {

namespace {
constexpr double kLongestLag = 0.1;  // s, that are made up for
constexpr double kMostTicks = kLongestLag * kTicksPerSecond;
}  // namespace

const char* why_time_stands_still(const World& world, const SplitView& split, const StageWishes& stages,
                                  const Opening& opening) {
  if (opening.loader.busy()) return "A file is being opened.";
  if (split.shown) return "Bodies stand still in the split view.";
  if (stages.on) return "Bodies stand still during single steps.";
  return world.live_faces() == 0 ? "There is nothing that could move." : nullptr;
}

void TimeFlow::advance(double seconds) {
  PlayState& play = on_.play;
  if (!may_go_on()) return end();
  const Document& document = on_.work.document;
  due_ += std::min(seconds, kLongestLag) * play.speed().of_real_time * kTicksPerSecond;
  if (on_.changes.is_pending() || document.waiting() > 0) {
    most_ = std::max(1.0, 0.5 * most_);
    due_ = std::min(due_, most_);
    return;
  }
  most_ = std::min(most_ + 1, kMostTicks);
  due_ = std::min(due_, most_);
  if (!begin()) return;
  const bool single = std::exchange(play.one_tick, false);
  const auto ticks = single ? Ticks{1} : static_cast<Ticks>(due_);
  if (ticks > 0) queue_ticks(ticks);
  if (single) begun_ = false;  // each single tick is a step of the history
}

void TimeFlow::end() {
  due_ = 0;
  before_ground_.reset();
  if (!begun_ || on_.changes.is_pending() || on_.work.document.waiting() > 0) return;
  mark_state(on_.work.document, on_.work.marks, true);
  begun_ = false;
}

// Ends playing where it has to end.
bool TimeFlow::may_go_on() {
  PlayState& play = on_.play;
  const size_t position = on_.work.document.history().position();
  const bool undone = position < std::exchange(position_, position);
  if (!play.playing && !play.one_tick) return false;
  if (on_.changes.is_pending()) return true;
  const char* why_not = why_time_stands_still(on_.work.document.world(), on_.split, on_.stages, on_.opening);
  if (why_not != nullptr) on_.message.say(why_not);
  if (why_not != nullptr || (undone && begun_)) play.stop();
  return play.playing || play.one_tick;
}

// Returns false while something else has to be done first.
bool TimeFlow::begin() {
  if (begun_) return true;
  Document& document = on_.work.document;
  if (on_.view.spread != 0) {
    on_.view.spread = 0;
    spread_pieces(document.world(), 0, on_.view.look);
  }
  const Surroundings fitting = fitting_surroundings(document.world(), on_.view.frame);
  if (fitting != document.world().surroundings()) {
    if (document.in_stroke()) return false;
    before_ground_ = document.history().position();
    on_.changes.apply(SetSurroundings{fitting});
    return false;
  }
  if (!document.in_stroke()) document.apply(Play{});
  position_ = document.history().position();
  // The user has done nothing in between: one undo takes the ground away, too.
  if (before_ground_ && position_ == *before_ground_ + 2) on_.groups.add(*before_ground_, document, "Play");
  before_ground_.reset();
  return begun_ = true;
}

// The spring of the document becomes that of the hand.
void TimeFlow::queue_spring() {
  Document& document = on_.work.document;
  const bool held = on_.hand.drag == Drag::kPull && on_.hand.spring;
  if (!held && document.world().spring()) document.apply(LetGo{});
  if (held && document.world().spring() != on_.hand.spring)
    document.apply(Pull{on_.hand.spring->piece, on_.hand.spring->at, on_.hand.spring->to});
}

// Up to a full minute at most.
void TimeFlow::queue_ticks(Ticks ticks) {
  OpenWork& work = on_.work;
  const Ticks of_minute = work.document.world().clock() % Document::kTicksToForget;
  if (of_minute == 0) mark_state(work.document, work.marks, true);
  ticks = std::min(ticks, Document::kTicksToForget - of_minute);
  due_ -= std::min(due_, static_cast<double>(ticks));
  queue_spring();
  work.document.apply(Advance{ticks, true});
}

}  // namespace kerf
