#include "core/document/history/run_queue.h"

#include <algorithm>

namespace kerf {

Status run_queue(Document& document, const QueueRun& how) {
  const auto all = static_cast<double>(document.waiting() - std::min(document.waiting(), how.leave));
  while (document.waiting() > how.leave) {
    const size_t left = document.waiting() - how.leave;
    const Progress going = share_of(how.progress, std::max(0.0, 1 - static_cast<double>(left) / all), 1);
    if (!going.report(0)) return cancelled();
    const Result<StepResult> some = document.step(std::min(left, how.moves_a_step), &going);
    const Status heard = how.told ? how.told(some) : some ? Status(Done{}) : Status(some.error());
    if (!heard) return heard;
  }
  return Done{};
}

Outcome stop_strokes(Document& document) {
  document.apply(EndStroke{});
  Outcome all;
  const History& history = document.history();
  while (all.ok() && document.execution().beam_waits() && history.position() > 0 && history.last().waiting())
    all.append(document.apply(Undo{}));
  if (!all.ok()) return all;
  if (const auto here = document.execution().stop_here()) all.append(document.apply(*here));
  return all;
}

}  // namespace kerf
