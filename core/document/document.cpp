#include "core/document/document.h"

#include <algorithm>
#include <limits>
#include <tuple>

#include "core/base/assert.h"
#include "core/document/commands.h"
#include "core/document/extract.h"

namespace kerf {

namespace {

// Creates a step with its first command. Bodies that it creates get the number of the command in the
// journal as their generation, which is the same in a replay of the journal.
HistoryStep step_begun_by(const Command& first, const World& world, size_t number) {
  HistoryStep step(first);
  step.generation = static_cast<uint32_t>(number);
  const std::optional<PieceId> piece = piece_of(first);
  if (piece && has_faces(world, *piece)) step.piece_name = world.body(piece->body).name_of(piece->label);
  return step;
}

// Returns true if before-images can restore the world at the start of a step.
bool can_run_again(const UndoStack& steps, size_t step) {
  return steps.holds_images(steps.base_of(step), step);
}

}  // namespace

Outcome Document::apply(const Command& command, const Progress* progress) {
  Outcome outcome;
  std::visit(Overloaded{
                 [&](const BeginStroke& c) { begin_stroke(c); },
                 [&](const MoveBeam& c) { move_stroke(c); },
                 [&](const EndStroke&) { end_stroke(); },
                 [&](const StopStroke& c) { outcome = stop(c, progress); },
                 [&](const TimedCommand auto& c) { add_in_time(c); },
                 [&](const Play& c) {
                   end_stroke();
                   begin_step(c);
                   journal_.append(c);
                 },
                 [&](const Recut& c) { outcome = recut(c); },
                 [&](const Undo&) { outcome = undo(progress); },
                 [&](const Redo&) { outcome = redo(progress); },
                 [&](const ImmediateCommand auto& c) { outcome = do_at_once(c, progress); },
             },
             command);
  return outcome;
}

void Document::begin_stroke(const BeginStroke& command) {
  end_stroke();
  begin_step(command);
  ++revision_;
  queue_.enqueue(history().position() - 1, command);
  journal_.append(command);
}

void Document::move_stroke(const MoveBeam& command) {
  if (!queue_.in_stroke()) return;
  last().add(command);
  queue_.enqueue(history().position() - 1, command);
  journal_.append(command);
}

void Document::end_stroke() {
  if (!queue_.in_stroke()) return;
  const size_t step = history().position() - 1;
  last().add(EndStroke{});
  queue_.enqueue(step, EndStroke{});
  journal_.append(EndStroke{});
  queue_.finish(step);
}

void Document::begin_step(const Command& first) {
  queue_.history().append(step_begun_by(first, world(), journal_.size() + 1));
}

void Document::add_in_time(const Command& command) {
  const auto* time = std::get_if<AdvanceTime>(&command);
  if (time && time->ticks == 0) return;
  queue_.history().drop_undone();
  const bool first = history().position() == 0;
  if (history_step_kind(command, first ? std::nullopt : std::optional(last().kind()))) {
    begin_step(command);
  } else {
    last().add(command);
    last().reopen();
  }
  queue_.enqueue(history().position() - 1, command);
  journal_.append(command);
}

Outcome Document::do_at_once(const Command& command, const Progress* progress) {
  end_stroke();
  Outcome all = finish(progress);
  if (!all.ok()) return all;
  HistoryStep step = step_begun_by(command, world(), journal_.size() + 1);
  Result<Delta> own = queue_.run(step, history().position(), progress);
  if (!own) {
    all.fail(own.error());
  } else if (!own->empty()) {
    journal_.append(step.commands().front());
    queue_.history().append(std::move(step));
    queue_.history().trim();
    all.delta.append(std::move(*own));
  }
  return all;
}

Outcome Document::redo_at_once(size_t at, const Progress* progress) {
  Outcome all = finish(progress);
  if (!all.ok()) return all;
  UndoStack& steps = queue_.history();
  HistoryStep& step = steps.step(at);
  step.forget();
  steps.forget_behind(at);
  Result<Delta> own = queue_.run(step, at, progress);
  if (own) {
    steps.set_position(at + 1);
    for (size_t i = 1; i < step.commands().size(); ++i) {
      queue_.enqueue(at, step.commands()[i]);
      step.reopen();
    }
    all.delta.append(std::move(*own));
  } else {
    all.fail(own.error());
  }
  steps.trim();
  return all;
}

// Executing the queue ---------------------------------------------------------------------------------------

Result<StepResult> Document::execute(size_t most, bool one_stage, const Progress* progress) {
  bool stopped = false;
  const Progress watched{[&](double fraction) {
    stopped = progress && !progress->report(fraction);
    return !stopped;
  }};
  Result<StepResult> some = queue_.step(most, one_stage, watched);
  if (!some) give_up(queue_.pending().front_step(), stopped || queue_.is_over_budget());
  return some;
}

void Document::give_up(size_t step, bool stopped) {
  if (queue_.in_stroke() && stopped) end_stroke();
  ++revision_;
  if (!queue_.give_up(step, stopped) || !stopped) return;
  for (size_t i = history().position(); i > step; --i) journal_.append(Undo{});
  queue_.history().set_position(step);
  // A recut has undone the step before it without keeping its images.
  const bool again = step > 0 && history().last().waiting() && !queue_.pending().holds(step - 1);
  if (again && can_run_again(history(), step - 1)) queue_.run_again();
}

Outcome Document::finish(const Progress* progress) {
  Outcome all;
  QueueRun how;
  how.progress = progress;
  how.told = [&](const Result<StepResult>& some) -> Status {
    if (!some) return some.error();
    all.delta.append(some->delta);
    return Done{};
  };
  if (const Status ran = run_queue(*this, how); !ran) {
    all.delta.replaced = true;
    all.fail(ran.error());
  }
  return all;
}

Outcome Document::run_whole(std::span<const Command> commands, const Progress* progress) {
  end_stroke();
  Outcome all = finish(nullptr);
  if (!all.ok()) return all;
  const Status done = all_or_nothing([&]() -> Status {
    for (const Command& command : commands) {
      if (all.ok()) all.append(apply(command, progress));
    }
    end_stroke();
    if (all.ok()) all.append(finish(progress));
    return all.ok() ? Status(Done{}) : all.error();
  });
  if (!done) {
    all.delta.replaced = true;
    all.fail(done.error());
  }
  return all;
}

Status Document::all_or_nothing(const std::function<Status()>& work) {
  end_stroke();
  if (const Outcome before = finish(nullptr); !before.ok()) return before.error();
  queue_.close_and_trim();
  journal_.seal();
  const size_t position = history().position(), journal_size = journal_.size();
  UndoStack::Steps undone = queue_.history().take_undone();
  Status done = Done{};
  std::exception_ptr thrown;
  try {
    done = work();
  } catch (...) {
    thrown = std::current_exception();
  }
  if (done && !thrown) {
    if (journal_.size() == journal_size) queue_.history().put_undone(std::move(undone));
    return done;
  }
  const bool is_cutting =
      waiting() > 0 && history().position() > position && last().kind() == HistoryStep::Kind::kStroke;
  if (thrown && is_cutting) {
    try {
      (void)cancel_stroke();
    } catch (const std::bad_alloc&) {
      // undo_to() restores the world by images alone.
    }
  }
  const Status back = undo_to(position, journal_size, std::move(undone));
  if (thrown) std::rethrow_exception(thrown);
  return back ? done : back;
}

// Undone steps are executed again on redo: their images belong to a world that no other step has changed
// since.
Status Document::undo_to(size_t position, size_t journal_size, UndoStack::Steps undone) {
  for (const auto& step : undone) step->forget();
  const Outcome back = travel(position);
  if (!back.ok()) return back.error();
  journal_.shrink(journal_size);
  queue_.history().put_undone(std::move(undone));
  return Done{};
}

using Images = HistoryStep::Images;
using Kind = HistoryStep::Kind;

namespace {

// Returns true if bodies move in these commands of a step, so that pieces become bodies and take slots of
// the world. Slots are never reused, and ids name them: they must not depend on the progress of a step.
bool bodies_move_in(const std::vector<Command>& commands) {
  return std::any_of(commands.begin(), commands.end(), moves_bodies);
}

bool has_only_a_few_ticks(const CommandQueue& queue) {
  constexpr size_t kFewTicks = 24;
  const BeamQueue& pending = queue.pending();
  return queue.only_cools() ||
         (!pending.holds_beam() && pending.size() <= kFewTicks && !queue.next_searches());
}

}  // namespace

// If the beam has already passed the place, as in a replay, the stroke is recut up to it.
Outcome Document::stop(const StopStroke& command, const Progress* progress) {
  end_stroke();
  Outcome outcome;
  const size_t now = history().position();
  if (now == 0 || !history().cuts(now - 1)) return outcome;
  const std::optional<StopStroke> here = queue_.stop_here();
  last().add(command);
  if (here && std::tie(here->moves, here->ticks) <= std::tie(command.moves, command.ticks)) {
    queue_.enqueue(now - 1, command);
    if (!last().waiting()) queue_.finish(now - 1);
  } else if (can_restart_stroke(*this)) {
    outcome.delta = restart_stroke();
  } else {
    outcome = replay(now, progress);
    // A replay that was cancelled within the stroke has queued the rest of it, up to the stop.
    const bool is_stopped = outcome.delta.replaced && history().position() == now;
    if (!outcome.ok() && !is_stopped) {
      queue_.history().step(now - 1).take_out_last();
      return outcome;
    }
  }
  journal_.append(command);
  ++revision_;
  return outcome;
}

Outcome Document::cancel_stroke() {
  KERF_ASSERT(history().position() > 0 && history().last().kind() == Kind::kStroke);
  Outcome all;
  while (queue_.pending().unfinished_rim().is_uninterruptible()) {
    Result<StepResult> some = execute(1, false, nullptr);
    if (!some) {
      all.fail(some.error());
      return all;
    }
    all.delta.append(std::move(some->delta));
  }
  end_stroke();
  const size_t at = history().position() - 1;
  if (last().images() == Images::kDiscarded) {
    all.fail(failed("the state before the stroke is no longer stored"));
    return all;
  }
  all.delta.append(queue_.undo(at));
  queue_.history().set_position(at);
  queue_.history().drop_undone();
  const std::vector<Command>& commands = journal_.commands();
  size_t begin = commands.size();
  do {
    KERF_ASSERT(begin > 0);
  } while (!std::holds_alternative<BeginStroke>(commands[--begin]));
  journal_.shrink(begin);
  ++revision_;
  return all;
}

std::optional<World> Document::before_last_stroke() {
  const auto stroke = history().last_cut();
  if (!stroke || *stroke + 1 != history().position() || world().live_faces() > kMaxFacesToCopy)
    return std::nullopt;
  return queue_.copy_before(history().base_of(*stroke));
}

Outcome Document::recut(const Recut& command) {
  end_stroke();
  Outcome all;
  if (can_recut(*this) && bodies_move_in(history().commands_of(history().position() - 1)))
    all = finish(nullptr);
  if (!all.ok() || !can_recut(*this)) return all;
  begin_step(command);
  journal_.append(command);
  ++revision_;
  all.delta.append(queue_.run_again());
  return all;
}

Delta Document::restart_stroke() {
  KERF_ASSERT(can_restart_stroke(*this));
  Delta delta = queue_.undo(history().position() - 1);
  last().forget();
  delta.append(queue_.run_again());
  ++revision_;
  return delta;
}

// Executes a queue of only a few ticks first: a step that is done when it is undone can be redone by its
// images.
Outcome Document::undo(const Progress* progress) {
  end_stroke();
  Outcome passed = has_only_a_few_ticks(queue_) ? finish(nullptr) : Outcome();
  UndoStack& steps = queue_.history();
  if (steps.position() == 0) return Outcome();
  const size_t at = steps.position() - 1;
  HistoryStep& step = steps.step(at);
  // A recut may have undone the step before it without keeping its images.
  const bool again = at > 0 && steps.step(at - 1).waiting() && !queue_.pending().holds(at - 1);
  if (step.images() == Images::kDiscarded || (again && !can_run_again(steps, at - 1))) {
    if (passed.ok()) passed.append(replay(at, progress));
    return passed;
  }
  Delta delta = std::move(passed.delta);
  delta.append(queue_.undo(at));
  if (!step.done()) step.forget();
  steps.set_position(at);
  if (again) delta.append(queue_.run_again());
  steps.trim();
  journal_.append(Undo{});
  ++revision_;
  return Outcome(std::move(delta));
}

Outcome Document::redo(const Progress* progress) {
  end_stroke();
  UndoStack& steps = queue_.history();
  if (steps.position() == steps.size()) return Outcome();
  const size_t at = steps.position();
  HistoryStep& step = steps.step(at);
  Outcome outcome;
  if (step.images() == Images::kHeld && step.done() && queue_.pending().empty()) {
    outcome.delta = queue_.redo(at);
    steps.set_position(at + 1);
  } else if (step.kind() == Kind::kEdit) {
    outcome = redo_at_once(at, progress);
    if (!outcome.ok()) return outcome;
  } else {
    if (!can_run_again(steps, at)) return replay(at + 1, progress);
    step.forget();
    steps.set_position(at + 1);
    outcome.delta = queue_.run_again();
  }
  journal_.append(Redo{});
  ++revision_;
  return outcome;
}

Outcome Document::travel(size_t position, const Progress* progress) {
  end_stroke();
  position = std::min(position, history().size());
  if (!history().holds_images(position, history().position())) return replay(position, progress);
  Outcome all;
  while (all.ok() && history().position() != position)
    all.append(history().position() > position ? undo(progress) : redo(progress));
  return all;
}

// Replays from the origin. If the origin is not available, nothing changes.
Outcome Document::replay(size_t position, const Progress* progress) {
  Outcome outcome;
  if (!origin_) {
    outcome.fail(failed("the earlier state of the world is no longer stored"));
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
  queue_.start_with(std::move(*origin));
  outcome.delta.replaced = true;
  if (const Status done = replay_steps(position, &running); !done) outcome.fail(done.error());
  journal_.shrink(written);
  for (size_t i = history().position(); i < before; ++i) journal_.append(Undo{});
  for (size_t i = before; i < history().position(); ++i) journal_.append(Redo{});
  return outcome;
}

// Executes a step of a replay. A stroke that fails by itself failed so before, and only its time passes.
Outcome Document::finish_again(size_t step, const Progress& progress) {
  bool stopped = false;
  const Progress watched{[&](double fraction) {
    stopped = !progress.report(fraction);
    return !stopped;
  }};
  Outcome done = finish(&watched);
  const bool failed_by_itself = !done.ok() && !stopped && !queue_.is_over_budget();
  return failed_by_itself && history().position() == step + 1 ? finish(&watched) : done;
}

// Skips a stroke that is recut immediately, unless bodies move under it. Then the stroke is cut, and its
// before-images are kept until the recut is done.
Status Document::replay_steps(size_t position, const Progress* progress) {
  UndoStack& steps = queue_.history();
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
      steps.set_position(step + 1);
      const bool again = step + 1 < position && steps.step(step + 1).kind() == Kind::kRecut;
      if (again && !bodies_move_in(steps.commands_of(step))) continue;
      if (again) steps.set_window(std::numeric_limits<size_t>::max());
      queue_.run_again();
      done = finish_again(step, running);
      if (!again || !done.ok()) steps.set_window(window);
    }
    if (!done.ok()) return done.error();
  }
  return Done{};
}

std::optional<Document::SavePoint> Document::SavePoint::create(Document& document) {
  if (document.history().position() == 0) return std::nullopt;
  std::optional<CommandQueue::SavePoint> reached = document.queue_.save_point();
  if (!reached) return std::nullopt;
  return SavePoint(document, std::move(*reached));
}

bool Document::SavePoint::can_restore(const Document& document) const {
  return !document.queue().in_stroke() && revision_ == document.revision() &&
         position_ == document.history().position() && reached_.step.can_restore(document.history().last());
}

Delta Document::SavePoint::restore(Document& document) const {
  KERF_ASSERT(can_restore(document));
  ++document.revision_;
  return document.queue_.restore(reached_);
}

bool can_recut(const Document& document) {
  return !document.queue().in_stroke() && can_restart_stroke(document);
}

bool can_restart_stroke(const Document& document) {
  const UndoStack& history = document.history();
  const size_t now = history.position();
  return now > 0 && history.cuts(now - 1) && history.holds_images(history.base_of(now - 1), now);
}

Status run_queue(Document& document, const QueueRun& how) {
  const auto all = static_cast<double>(document.waiting() - std::min(document.waiting(), how.leave));
  while (document.waiting() > how.leave) {
    const size_t left = document.waiting() - how.leave;
    const Progress going = share_of(how.progress, std::max(0.0, 1 - static_cast<double>(left) / all), 1);
    if (!going.report(0)) return cancelled();
    const Result<StepResult> some = document.step(std::min(left, how.moves_a_step), &going);
    const Status status = how.told ? how.told(some) : some ? Status(Done{}) : Status(some.error());
    if (!status) return status;
  }
  return Done{};
}

Outcome stop_strokes(Document& document) {
  document.apply(EndStroke{});
  Outcome all;
  const UndoStack& history = document.history();
  while (all.ok() && document.queue().pending().holds_beam() && history.position() > 0 &&
         history.last().waiting())
    all.append(document.apply(Undo{}));
  if (!all.ok()) return all;
  if (const auto here = document.queue().stop_here()) all.append(document.apply(*here));
  return all;
}

}  // namespace kerf
