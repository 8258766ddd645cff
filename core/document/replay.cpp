#include "core/document/replay.h"

#include "core/world/state_hash.h"

namespace kerf {

double Replay::fraction() const {
  const size_t all = journal_.commands.size();
  return all > 0 ? static_cast<double>(next_) / static_cast<double>(all) : 1;
}

void Replay::next_command() {
  compare();
  document_.apply(journal_.commands[next_++]);
  compare();
}

Result<StepResult> Replay::step(size_t moves, const Progress* progress) {
  Result<StepResult> result = document_.step(moves, progress);
  compare();
  return result;
}

Result<StepResult> Replay::advance(size_t moves, const Progress* progress) {
  if (document_.waiting() == 0 && next_ < journal_.commands.size()) next_command();
  return step(moves, progress);
}

// Marks that stand where the document is now and nothing waits.
void Replay::compare() {
  for (; document_.waiting() == 0 && next_mark_ < journal_.marks.size() &&
         journal_.marks[next_mark_].commands <= next_;
       ++next_mark_) {
    const StateMark& mark = journal_.marks[next_mark_];
    if (difference_ || mark.commands < next_) continue;
    const uint64_t hash = state_hash(document_.world());
    if (hash != mark.hash) difference_ = Difference{mark, hash};
  }
}

}  // namespace kerf
