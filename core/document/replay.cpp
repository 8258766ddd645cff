#include "core/document/replay.h"

#include "core/world/state_hash.h"

namespace kerf {

double Replay::fraction() const {
  const size_t all = journal_.commands.size();
  return all > 0 ? static_cast<double>(next_) / static_cast<double>(all) : 1;
}

Result<Delta> Replay::next_command(const Progress* progress) {
  compare();
  Result<Delta> delta = document_.apply(journal_.commands[next_++], progress);
  compare();
  return delta;
}

Result<StepResult> Replay::step(size_t moves, const Progress* progress) {
  Result<StepResult> result = document_.step(moves, progress);
  compare();
  return result;
}

Result<StepResult> Replay::advance(size_t moves, const Progress* progress) {
  Delta at_once;
  if (document_.waiting() == 0 && next_ < journal_.commands.size()) {
    Result<Delta> delta = next_command(progress);
    if (!delta) return delta.error();
    at_once = std::move(*delta);
  }
  Result<StepResult> result = step(moves, progress);
  if (!result) return result;
  at_once.append(std::move(result->delta));
  result->delta = std::move(at_once);
  return result;
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
