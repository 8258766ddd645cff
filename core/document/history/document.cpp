#include "core/document/history/document.h"

#include <algorithm>

#include "core/base/assert.h"
#include "core/document/commands/edit_piece.h"
#include "core/physics/forget_contacts.h"

namespace kerf {

Outcome Document::apply(const Command& command, const Progress* progress) {
  const auto queued = [&](const auto& c) {
    apply(c);
    return Outcome();
  };
  return std::visit(Overloaded{
                        [&](const BeginStroke& c) { return queued(c); },
                        [&](const MoveStroke& c) { return queued(c); },
                        [&](const EndStroke& c) { return queued(c); },
                        [&](const StopStroke& c) { return stop(c, progress); },
                        [&](const HappensInTime auto& c) { return queued(c); },
                        [&](const Play& c) { return queued(c); },
                        [&](const Recut& c) { return recut(c); },
                        [&](const Undo&) { return undo(progress); },
                        [&](const Redo&) { return redo(progress); },
                        [&](const HappensAtOnce auto& c) { return do_at_once(c, progress); },
                    },
                    command);
}

// Drawing ---------------------------------------------------------------------------------------------------

void Document::apply(const BeginStroke& command) {
  end_stroke();
  begin_step(command);
  ++revision_;
  in_stroke_ = true;
  queue_command(history_.position() - 1, command);
  journal_.append(command);
}

void Document::apply(const MoveStroke& command) {
  if (!in_stroke_) return;
  history_.last().add(command);
  queue_command(history_.position() - 1, command);
  journal_.append(command);
}

void Document::apply(const EndStroke&) { end_stroke(); }

void Document::apply(const Advance& command) {
  if (command.ticks > 0) add_in_time(command);
}

void Document::apply(const Pull& command) { add_in_time(command); }

void Document::apply(const LetGo& command) { add_in_time(command); }

void Document::apply(const Play& command) {
  end_stroke();
  begin_step(command);
  journal_.append(command);
}

// Appends a step of which this is the first command. The bodies that it creates get the number of the command
// in the journal as their generation, which is the same when the journal is replayed.
void Document::begin_step(const Command& first) {
  HistoryStep step(first);
  step.generation = static_cast<uint32_t>(journal_.size() + 1);
  history_.append(std::move(step));
}

void Document::add_in_time(const Command& command) {
  history_.drop_undone();
  if (history_.position() == 0 || !belongs_to(history_.last().kind(), command)) {
    begin_step(command);
  } else {
    history_.last().add(command);
    history_.last().reopen();
  }
  queue_command(history_.position() - 1, command);
  journal_.append(command);
}

void Document::end_stroke() {
  if (!in_stroke_) return;
  const size_t step = history_.position() - 1;
  history_.last().add(EndStroke{});
  queue_command(step, EndStroke{});
  journal_.append(EndStroke{});
  in_stroke_ = false;
  finish_step(step);
}

// Queues what a command asks for that does not happen at once.
void Document::queue_command(size_t step, const Command& command) {
  const auto move_to = [&](const BeamAt& next) {
    const BeamMove move{drawn_->beam.pose, next.pose, next.time - drawn_->beam.time};
    queue_.push_move(step, drawn_, move, world_);
    drawn_->beam = next;
  };
  std::visit(Overloaded{
                 [&](const BeginStroke& c) {
                   drawn_ = std::make_shared<Stroke>();
                   drawn_->settings = c.settings;
                   drawn_->beam = {c.pose, 0};
                   move_to({c.pose, 0});
                 },
                 [&](const MoveStroke& c) {
                   move_to({c.pose, c.time});
                 },
                 [&](const EndStroke&) {
                   drawn_->ended = true;
                   if (drawn_->settings.smooth()) queue_.push_rim(step, drawn_);
                 },
                 [&](const StopStroke& c) { queue_.stop(step, c, world_); },
                 [&](const Advance& c) {
                   const bool beam = c.bodies && drawn_ && !drawn_->ended;
                   queue_.push_ticks(step, c.ticks, c.bodies, beam ? drawn_ : nullptr);
                 },
                 [&](const Pull& c) {
                   queue_.push_spring(step, Spring{c.piece, c.at, c.to});
                 },
                 [&](const LetGo&) { queue_.push_spring(step, std::nullopt); },
                 [&](const Play&) {},
                 [&](const Recut&) { KERF_ASSERT(!"queued by the commands of its stroke"); },
                 [&](const Undo&) { KERF_ASSERT(!"never part of a step"); },
                 [&](const Redo&) { KERF_ASSERT(!"never part of a step"); },
                 [&](const HappensAtOnce auto&) { KERF_ASSERT(!"happens at once"); },
             },
             command);
}

void Document::queue_commands(size_t step) {
  for (const Command& c : history_.commands_of(step)) queue_command(step, c);
}

// Queues the time that belongs to an edit.
void Document::queue_time_of_edit(size_t at) {
  HistoryStep& edit = history_.step(at);
  if (edit.commands().size() == 1) return;
  for (size_t i = 1; i < edit.commands().size(); ++i) queue_command(at, edit.commands()[i]);
  edit.reopen();
}

// Commands that happen at once ------------------------------------------------------------------------------

// Runs the command of a step that stands, or will stand, at `at` in the history. On failure the world is as
// it was.
Result<Delta> Document::run(HistoryStep& step, size_t at, const Progress* progress) {
  close_and_trim();
  step.begin(history_.window() > 0);
  recorder_.open(world_, at, history_.window() > 0);
  Result<Delta> delta = std::visit(Overloaded{
                                       [&](HappensAtOnce auto& c) {
                                         if constexpr (requires { c.piece; })
                                           c.piece = whole_id(world_, c.piece);
                                         return c.run(world_, step.generation, progress);
                                       },
                                       [&](const auto&) -> Result<Delta> {
                                         KERF_ASSERT(!"this command does not happen at once");
                                         return Delta{};
                                       },
                                   },
                                   step.first());
  if (delta) forget_contacts(world_, *delta);
  std::optional<World::Change> change = recorder_.close(world_);
  if (!delta) {
    step.forget();
    return delta;
  }
  if (change) step.add(std::move(*change));
  step.touch(*delta);
  step.finish();
  physics_.follow(*delta);
  return delta;
}

Outcome Document::do_at_once(const Command& command, const Progress* progress) {
  end_stroke();
  Outcome all = finish(progress);
  if (!all.ok()) return all;
  HistoryStep step(command);
  step.generation = static_cast<uint32_t>(journal_.size() + 1);
  Result<Delta> own = run(step, history_.position(), progress);
  if (!own) {
    all.fail(own.error());
  } else if (!own->empty()) {
    journal_.append(step.first());
    history_.append(std::move(step));
    history_.trim();
    all.delta.append(std::move(*own));
  }
  return all;
}

Outcome Document::redo_at_once(size_t at, const Progress* progress) {
  Outcome all = finish(progress);
  if (!all.ok()) return all;
  HistoryStep& step = history_.step(at);
  step.forget();
  history_.forget_behind(at);
  Result<Delta> own = run(step, at, progress);
  if (own) {
    history_.forth();
    queue_time_of_edit(at);
    all.delta.append(std::move(*own));
  } else {
    all.fail(own.error());
  }
  history_.trim();
  return all;
}

}  // namespace kerf
