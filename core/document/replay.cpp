#include "core/document/replay.h"

#include <cassert>

#include "core/physics/machine_kind.h"
#include "core/world/state_hash.h"

namespace kerf {

double Replay::fraction() const {
  const size_t all = journal_.commands.size();
  return all > 0 ? static_cast<double>(next_) / static_cast<double>(all) : 1;
}

// Tells of what a command did at once; of one that only queued, its steps tell.
Status Replay::tell(const Walk& how, Outcome at_once) const {
  if (!how.told) return at_once.ok() ? Status(Done{}) : Status(at_once.error());
  if (!at_once.ok()) return how.told(at_once.error());
  if (at_once.delta.empty() && document_.waiting() > 0) return Done{};
  StepResult result;
  result.delta = std::move(at_once.delta);
  return how.told(std::move(result));
}

Status Replay::next(const Walk& how) {
  assert(!done());
  compare();
  if (next_ < journal_.commands.size()) {
    Outcome at_once = document_.apply(journal_.commands[next_++], how.progress);
    document_.seal_journal();  // so that it has the same commands, by number too
    if (const Status heard = tell(how, std::move(at_once)); !heard) return heard;
  }
  const Status walked = walk(document_, how);
  compare();
  return walked;
}

Status Replay::run(const Walk& how) {
  const Progress watched{[&](double) { return !how.progress || how.progress->report(fraction()); }};
  Walk each = how;
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
    if (hash != mark.hash) difference_ = Difference{mark, hash};
  }
}

// Bodies move to other bits on another kind of machine.
bool Replay::takes_bodies(const StateMark& mark) {
  if (mark.bodies.empty() || mark.machine == machine_kind()) return false;
  other_machine_ = mark.machine;
  document_.take_states(mark.bodies);
  return true;
}

}  // namespace kerf
