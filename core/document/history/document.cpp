#include "core/document/history/document.h"

#include <algorithm>

#include "core/document/commands/command_words.h"
#include "core/document/commands/edit_piece.h"
#include "core/document/history/run_queue.h"

namespace kerf {

namespace {

// A step of which this is the first command. The bodies that it creates get the number of the command in the
// journal as their generation, which is the same when the journal is replayed.
HistoryStep step_begun_by(const Command& first, const World& world, size_t number) {
  HistoryStep step(first);
  step.generation = static_cast<uint32_t>(number);
  const std::optional<PieceId> piece = piece_of(first);
  if (piece && has_faces(world, *piece)) step.piece_name = world.body(piece->body).name_of(piece->label);
  return step;
}

}  // namespace

Outcome Document::apply(const Command& command, const Progress* progress) {
  Outcome outcome;
  std::visit(Overloaded{
                 [&](const BeginStroke& c) { begin_stroke(c); },
                 [&](const MoveBeam& c) { move_stroke(c); },
                 [&](const EndStroke&) { end_stroke(); },
                 [&](const StopStroke& c) { outcome = stop(c, progress); },
                 [&](const HappensInTime auto& c) { add_in_time(c); },
                 [&](const Play& c) {
                   end_stroke();
                   begin_step(c);
                   journal_.append(c);
                 },
                 [&](const Recut& c) { outcome = recut(c); },
                 [&](const Undo&) { outcome = undo(progress); },
                 [&](const Redo&) { outcome = redo(progress); },
                 [&](const HappensAtOnce auto& c) { outcome = do_at_once(c, progress); },
             },
             command);
  return outcome;
}

void Document::begin_stroke(const BeginStroke& command) {
  end_stroke();
  begin_step(command);
  ++revision_;
  execution_.enqueue(history().position() - 1, command);
  journal_.append(command);
}

void Document::move_stroke(const MoveBeam& command) {
  if (!execution_.in_stroke()) return;
  last().add(command);
  execution_.enqueue(history().position() - 1, command);
  journal_.append(command);
}

void Document::end_stroke() {
  if (!execution_.in_stroke()) return;
  const size_t step = history().position() - 1;
  last().add(EndStroke{});
  execution_.enqueue(step, EndStroke{});
  journal_.append(EndStroke{});
  execution_.finish(step);
}

void Document::begin_step(const Command& first) {
  execution_.history().append(step_begun_by(first, world(), journal_.size() + 1));
}

void Document::add_in_time(const Command& command) {
  const auto* time = std::get_if<AdvanceTime>(&command);
  if (time && time->ticks == 0) return;
  execution_.history().drop_undone();
  const bool first = history().position() == 0;
  if (begun_by(command, first ? std::nullopt : std::optional(last().kind()))) {
    begin_step(command);
  } else {
    last().add(command);
    last().reopen();
  }
  execution_.enqueue(history().position() - 1, command);
  journal_.append(command);
}

Outcome Document::do_at_once(const Command& command, const Progress* progress) {
  end_stroke();
  Outcome all = finish(progress);
  if (!all.ok()) return all;
  HistoryStep step = step_begun_by(command, world(), journal_.size() + 1);
  Result<Delta> own = execution_.run(step, history().position(), progress);
  if (!own) {
    all.fail(own.error());
  } else if (!own->empty()) {
    journal_.append(step.first());
    execution_.history().append(std::move(step));
    execution_.history().trim();
    all.delta.append(std::move(*own));
  }
  return all;
}

Outcome Document::redo_at_once(size_t at, const Progress* progress) {
  Outcome all = finish(progress);
  if (!all.ok()) return all;
  History& steps = execution_.history();
  HistoryStep& step = steps.step(at);
  step.forget();
  steps.forget_behind(at);
  Result<Delta> own = execution_.run(step, at, progress);
  if (own) {
    steps.forth();
    execution_.enqueue_time_of_edit(at);
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
  Result<StepResult> some = execution_.step(most, one_stage, watched);
  if (!some) give_up(execution_.next_step(), stopped || execution_.is_over_budget());
  return some;
}

// A stroke that was stopped is undone, with all that waits behind it.
void Document::give_up(size_t step, bool stopped) {
  if (execution_.in_stroke() && stopped) end_stroke();
  ++revision_;
  if (!execution_.give_up(step, stopped) || !stopped) return;
  for (; history().position() > step; execution_.history().back()) journal_.append(Undo{});
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
    all.delta.anew = true;
    all.fail(ran.error());
  }
  return all;
}

Outcome Document::run_whole(std::span<const Command> commands, const Progress* progress) {
  end_stroke();
  Outcome all = finish(nullptr);
  if (!all.ok()) return all;
  execution_.close_and_trim();
  journal_.seal();
  const size_t position = history().position(), journal_size = journal_.size();
  std::vector<std::unique_ptr<HistoryStep>> undone = execution_.history().take_undone();
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
  execution_.history().put_undone(std::move(undone));
  return Done{};
}

}  // namespace kerf
