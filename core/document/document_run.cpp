#include <cassert>

#include "core/document/document.h"

namespace kerf {

Outcome Document::run_whole(std::span<const Command> commands, const Progress* progress) {
  end_stroke();
  Outcome all = finish(nullptr);
  if (!all.ok()) return all;
  close_and_trim();
  journal_.seal();
  const size_t position = history_.position(), journal_size = journal_.size();
  std::vector<std::unique_ptr<HistoryStep>> undone = history_.take_undone();
  for (const Command& command : commands) apply(command);
  end_stroke();
  Outcome own = finish(progress);
  const bool done = own.ok();
  all.append(std::move(own));
  if (done) return all;
  if (const Status back = take_back_to(position, journal_size, std::move(undone)); !back)
    all.fail(back.error());
  return all;
}

// The undone steps are executed again when they are redone: their images belong to a world that no other step
// has changed meanwhile.
Status Document::take_back_to(size_t position, size_t journal_size,
                              std::vector<std::unique_ptr<HistoryStep>> undone) {
  for (const auto& step : undone) step->forget();
  const Outcome back = travel(position);
  if (!back.ok()) return back.error();
  journal_.shrink(journal_size);
  history_.put_undone(std::move(undone));
  return Done{};
}

}  // namespace kerf
