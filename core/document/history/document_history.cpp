#include <algorithm>
#include <limits>
#include <tuple>

#include "core/base/assert.h"
#include "core/document/history/document.h"

namespace kerf {

using Images = HistoryStep::Images;
using Kind = HistoryStep::Kind;

namespace {

// Whether bodies move in these commands of a step, so that pieces become bodies and take slots of the world.
// Slots are not used again, and ids name them: they must not depend on how far a step was executed.
bool bodies_move_in(const std::vector<Command>& commands) {
  return std::any_of(commands.begin(), commands.end(), [](const Command& command) {
    const auto* advance = std::get_if<AdvanceTime>(&command);
    return advance != nullptr && advance->bodies;
  });
}

}  // namespace

bool Document::can_recut() const {
  const auto stroke = history().last_cut();
  return !execution_.in_stroke() && stroke && is_last(*stroke) &&
         history().holds_images(history().base_of(*stroke), history().position());
}

// Where the beam has come further than to there, as in a replay, the stroke is cut again up to there.
Outcome Document::stop(const StopStroke& command, const Progress* progress) {
  end_stroke();
  Outcome outcome;
  const size_t now = history().position();
  if (now == 0 || !history().cuts(now - 1)) return outcome;
  const std::optional<StopStroke> here = execution_.stop_here();
  last().add(command);
  if (here && std::tie(here->moves, here->ticks) <= std::tie(command.moves, command.ticks)) {
    execution_.stop(command);
  } else if (can_start_again()) {
    outcome.delta = start_again();
  } else if (outcome = replay(now, progress); !outcome.ok()) {
    last().take_out_last();
    return outcome;
  }
  journal_.append(command);
  ++revision_;
  return outcome;
}

std::optional<World> Document::before_last_stroke() {
  const auto stroke = history().last_cut();
  if (!stroke || !is_last(*stroke) || world().live_faces() > kMostFacesToCopy) return std::nullopt;
  return execution_.copy_before(history().base_of(*stroke));
}

Outcome Document::recut(const Recut& command) {
  end_stroke();
  Outcome all;
  if (can_recut() && bodies_move_in(history().commands_of(history().position() - 1))) all = finish(nullptr);
  if (!all.ok() || !can_recut()) return all;
  begin_step(command);
  journal_.append(command);
  ++revision_;
  all.delta.append(execution_.cut_again());
  return all;
}

bool Document::can_start_again() const {
  const size_t now = history().position();
  return now > 0 && history().cuts(now - 1) && history().holds_images(history().base_of(now - 1), now);
}

Delta Document::start_again() {
  KERF_ASSERT(can_start_again());
  Delta delta = execution_.take_back(history().position() - 1);
  last().forget();
  delta.append(execution_.run_again());
  ++revision_;
  return delta;
}

std::optional<Document::Mark> Document::mark() {
  if (history().position() == 0) return std::nullopt;
  std::optional<Execution::Mark> reached = execution_.mark();
  if (!reached) return std::nullopt;
  return Mark{revision_, history().position(), std::move(*reached)};
}

bool Document::can_go_back_to(const Mark& mark) const {
  return !execution_.in_stroke() && mark.revision == revision_ && mark.position == history().position() &&
         history().last().can_go_back_to(mark.reached.step);
}

Delta Document::go_back_to(const Mark& mark) {
  KERF_ASSERT(can_go_back_to(mark));
  ++revision_;
  return execution_.go_back_to(mark.reached);
}

// The queue is executed first if it is only a little time: a step that is done when it is undone can be
// done again by its images.
Outcome Document::undo(const Progress* progress) {
  end_stroke();
  Outcome passed = execution_.only_a_few_ticks_wait() ? finish(nullptr) : Outcome();
  History& steps = execution_.history();
  if (steps.position() == 0) return Outcome();
  const size_t at = steps.position() - 1;
  HistoryStep& step = steps.step(at);
  // The step before was taken back for good where it was cut again.
  const bool again = at > 0 && steps.step(at - 1).waiting() && !execution_.waits_for(at - 1);
  if (step.images() == Images::kLetGo || (again && !execution_.can_run_again(at - 1)))
    return replay(at, progress);
  Delta delta = std::move(passed.delta);
  delta.append(execution_.take_back(at));
  if (!step.done()) step.forget();
  steps.back();
  if (again) delta.append(execution_.run_again());
  steps.trim();
  journal_.append(Undo{});
  ++revision_;
  return Outcome(std::move(delta));
}

Outcome Document::redo(const Progress* progress) {
  end_stroke();
  History& steps = execution_.history();
  if (steps.position() == steps.size()) return Outcome();
  const size_t at = steps.position();
  HistoryStep& step = steps.step(at);
  Outcome outcome;
  if (step.images() == Images::kHeld && step.done() && execution_.queue_is_empty()) {
    outcome.delta = execution_.bring_again(at);
    steps.forth();
  } else if (step.kind() == Kind::kEdit) {
    outcome = redo_at_once(at, progress);
    if (!outcome.ok()) return outcome;
  } else {
    if (!execution_.can_run_again(at)) return replay(at + 1, progress);
    step.forget();
    steps.forth();
    outcome.delta = execution_.run_again();
  }
  journal_.append(Redo{});
  ++revision_;
  return outcome;
}

bool Document::remembers_way_to(size_t position) const {
  return history().holds_images(position, history().position());
}

Outcome Document::travel(size_t position, const Progress* progress) {
  end_stroke();
  position = std::min(position, history().size());
  if (!remembers_way_to(position)) return replay(position, progress);
  Outcome all;
  while (all.ok() && history().position() != position)
    all.append(history().position() > position ? undo(progress) : redo(progress));
  return all;
}

// Starts again from the origin. Where that cannot be had, nothing has changed.
Outcome Document::replay(size_t position, const Progress* progress) {
  Outcome outcome;
  if (!origin_) {
    outcome.fail(failed("what the world was then is no longer remembered"));
    return outcome;
  }
  const Progress loading = share_of(progress, 0, 0.3), running = share_of(progress, 0.3, 1);
  Result<World> origin = origin_(&loading);
  if (!origin) {
    outcome.fail(origin.error());
    return outcome;
  }
  ++revision_;
  const size_t before = history().position(), written = journal_.size();
  execution_.start_with(std::move(*origin));
  outcome.delta.anew = true;
  if (const Status done = replay_steps(position, &running); !done) outcome.fail(done.error());
  journal_.shrink(written);
  for (size_t i = history().position(); i < before; ++i) journal_.append(Undo{});
  for (size_t i = before; i < history().position(); ++i) journal_.append(Redo{});
  return outcome;
}

// A stroke that is cut again right away need not be cut first, unless bodies move under it. Then it is cut,
// and its before-images are kept until it has been cut again.
Status Document::replay_steps(size_t position, const Progress* progress) {
  History& steps = execution_.history();
  const size_t window = steps.window();
  while (steps.position() < position) {
    const size_t step = steps.position();
    const double share = 1 / static_cast<double>(position), from = share * static_cast<double>(step);
    const Progress running = share_of(progress, from, from + share);
    Outcome done;
    if (steps.step(step).kind() == Kind::kEdit) {
      done = redo_at_once(step, &running);
      if (done.ok()) done = finish(&running);
    } else {
      steps.forth();
      const bool again = step + 1 < position && steps.step(step + 1).kind() == Kind::kRecut;
      if (again && !bodies_move_in(steps.commands_of(step))) continue;
      if (again) steps.set_window(std::numeric_limits<size_t>::max());
      execution_.run_again();
      done = finish(&running);
      if (!again || !done.ok()) steps.set_window(window);
    }
    if (!done.ok()) return done.error();
  }
  return Done{};
}

}  // namespace kerf
