
#include "core/base/assert.h"
#include "core/document/history/document.h"
#include "core/world/heat_flow.h"

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

StepResult Document::take_states(std::span<const BodyState> states, std::span<const NearPair> pairs) {
  KERF_ASSERT(waiting() == 0 && history_.position() > 0);
  const size_t step = history_.position() - 1;
  begin(step);
  StepResult taken;
  for (const BodyState& state : states) {
    if (!world_.contains(state.id)) continue;
    Body& body = world_.body(state.id);
    body.placement = state.placement;
    body.motion = state.motion;
    taken.delta.moved.push_back(state.id);
  }
  set_known_pairs(world_, pairs);
  note(step, taken);
  keep_open(step);
  return taken;
}

StepResult Document::skip_to(std::span<const BodyState> states, std::span<const NearPair> pairs) {
  while (!queue_.empty()) {
    if (queue_.front_kind() == BeamQueue::Kind::kSpring) {
      change_spring();
      continue;
    }
    KERF_ASSERT(queue_.front_kind() == BeamQueue::Kind::kTicks && !queue_.front_beam());
    begin(queue_.front_step());
    const Ticks ticks = queue_.front_ticks();
    world_.pass(ticks);
    cool_for_ticks(world_, ticks);
    queue_.pop_ticks(ticks);
  }
  return take_states(states, pairs);
}

}  // namespace kerf
