#include "core/document/journal/replay.h"

#include <algorithm>

#include "core/base/assert.h"
#include "core/physics/machine_kind.h"
#include "core/world/state_hash.h"

namespace kerf {

double Replay::fraction() const {
  const size_t all = journal_.commands.size();
  return all > 0 ? static_cast<double>(next_) / static_cast<double>(all) : 1;
}

// A stroke that was stopped is not executed until it is known where: behind its StopStroke, where one follows
// with nothing but its moves, its end and time before it.
size_t Replay::end_of_stopped() const {
  const auto goes_on = [](const Command& command) {
    return std::visit(Overloaded{
                          [](const MoveBeam&) { return true; },
                          [](const EndStroke&) { return true; },
                          [](const HappensInTime auto&) { return true; },
                          [](const auto&) { return false; },
                      },
                      command);
  };
  size_t end = next_ + 1;
  while (end < journal_.commands.size() && goes_on(journal_.commands[end])) ++end;
  return is_a<StopStroke>(end) ? end + 1 : next_ + 1;
}

// A stroke that is undone next is not executed either, unless a mark says what it led to: it may have been
// given up because it made more faces than there is memory for.
size_t Replay::end_of_undone() const {
  if (!is_a<BeginStroke>(next_)) return next_ + 1;
  size_t end = next_ + 1;
  while (is_a<MoveBeam>(end)) ++end;
  if (is_a<EndStroke>(end)) ++end;
  const bool marked = next_mark_ < journal_.marks.size() && journal_.marks[next_mark_].commands <= end;
  return is_a<Undo>(end) && !marked ? end + 1 : next_ + 1;
}

// Tells of what a command did at once; of one that only queued, its steps tell.
Status Replay::tell(const QueueRun& how, Outcome at_once) const {
  if (!how.told) return at_once.ok() ? Status(Done{}) : Status(at_once.error());
  if (!at_once.ok()) return how.told(at_once.error());
  if (at_once.delta.empty() && document_.waiting() > 0) return Done{};
  StepResult result;
  result.delta = std::move(at_once.delta);
  return how.told(std::move(result));
}

Status Replay::next(const QueueRun& how) {
  KERF_ASSERT(!done());
  compare();
  while (next_skip_ < skips_.size() && skips_[next_skip_].first < next_) ++next_skip_;
  if (next_skip_ < skips_.size() && skips_[next_skip_].first == next_) return skip(how, skips_[next_skip_]);
  const size_t end = next_ < journal_.commands.size() ? std::max(end_of_stopped(), end_of_undone()) : next_;
  while (next_ < end) {
    Outcome at_once = document_.apply(journal_.commands[next_++], how.progress);
    document_.seal_journal();  // so that it has the same commands, by number too
    if (const Status heard = tell(how, std::move(at_once)); !heard) return heard;
  }
  const Status ran = run_queue(document_, how);
  compare();
  return ran;
}

// In the first tick what came off becomes bodies; it is not skipped.
Status Replay::skip(const QueueRun& how, const TimeSkip& skip) {
  const StateMark& mark = journal_.marks[skip.mark];
  while (next_ < mark.commands) {
    (void)document_.apply(journal_.commands[next_++]);  // which only queues it
    document_.seal_journal();
  }
  const Ticks before = document_.world().clock();
  const auto say = [&](const Result<StepResult>& step) -> Status {
    if (how.told) return how.told(step);
    return step ? Status(Done{}) : Status(step.error());
  };
  while (document_.waiting() > 0 && document_.world().clock() == before) {
    if (const Status told = say(document_.step(1, how.progress)); !told) return told;
  }
  const Status told = say(document_.skip_to(mark.bodies, mark.pairs));
  skipped_ += skip.ticks;
  compare();
  return told;
}

Status Replay::run(const QueueRun& how) {
  const Progress watched{[&](double) { return !how.progress || how.progress->report(fraction()); }};
  QueueRun each = how;
  each.progress = &watched;
  while (!done()) {
    if (!watched.report(0)) return cancelled();
    if (const Status status = next(each); !status) return status;
  }
  return Done{};
}

// Marks that stand where the document is now and nothing waits.
void Replay::compare() {
  for (; document_.waiting() == 0 && next_mark_ < journal_.marks.size() &&
         journal_.marks[next_mark_].commands <= next_;
       ++next_mark_) {
    const StateMark& mark = journal_.marks[next_mark_];
    if (difference_ || mark.commands < next_) continue;
    uint64_t hash = state_hash(document_.world());
    if (hash != mark.hash && takes_bodies(mark)) hash = state_hash(document_.world());
    if (hash == mark.hash) continue;
    if (other_machine_.empty()) {
      difference_ = Difference{mark, hash};
    } else {
      cut_otherwise_ = true;
    }
  }
}

// Bodies move to other bits on another kind of machine.
bool Replay::takes_bodies(const StateMark& mark) {
  if (mark.bodies.empty() || mark.machine == machine_kind()) return false;
  other_machine_ = mark.machine;
  document_.take_states(mark.bodies, mark.pairs);
  return true;
}

}  // namespace kerf
