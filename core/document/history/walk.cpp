#include "core/document/history/walk.h"

#include <algorithm>

namespace kerf {

Status walk(Document& document, const Walk& how) {
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

}  // namespace kerf
