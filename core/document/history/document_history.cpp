#include <algorithm>
#include <limits>
#include <tuple>

#include "core/base/assert.h"
#include "core/document/history/document.h"
#include "core/physics/forget_contacts.h"

namespace kerf {

using Images = HistoryStep::Images;
using Kind = HistoryStep::Kind;

namespace {

// Whether bodies move in these commands of a step, so that pieces become bodies and take slots of the world.
// Slots are not used again, and ids name them: they must not depend on how far a step was executed.
bool bodies_move_in(const std::vector<Command>& commands) {
  return std::any_of(commands.begin(), commands.end(), [](const Command& command) {
    const auto* advance = std::get_if<Advance>(&command);
    return advance != nullptr && advance->bodies;
  });
}

}  // namespace

bool Document::can_recut() const {
  const auto last = history_.last_cut();
  return !in_stroke_ && last && is_last(*last) &&
         history_.holds_images(history_.base_of(*last), history_.position());
}

std::optional<StopStroke> Document::stop_here() const {
  const size_t now = history_.position();
  if (now == 0 || !history_.cuts(now - 1) || !queue_.holds_moves(now - 1)) return std::nullopt;
  return queue_.reached(now - 1);
}

// Where the beam has come further than to there, as in a replay, the stroke is cut again up to there.
Outcome Document::stop(const StopStroke& command, const Progress* progress) {
  end_stroke();
  Outcome outcome;
  const size_t now = history_.position();
  if (now == 0 || !history_.cuts(now - 1)) return outcome;
  const std::optional<StopStroke> here = stop_here();
  history_.last().add(command);
  if (here && std::tie(here->moves, here->ticks) <= std::tie(command.moves, command.ticks)) {
    queue_.stop(now - 1, command, world_);
    if (!history_.last().waiting()) finish_step(now - 1);
  } else if (can_start_again()) {
    outcome.delta = start_again();
  } else if (outcome = replay(now, progress); !outcome.ok()) {
    history_.last().take_out_last();
    return outcome;
  }
  journal_.append(command);
  ++revision_;
  return outcome;
}

std::optional<World> Document::before_last_stroke() {
  const auto last = history_.last_cut();
  if (!last || !is_last(*last) || world_.live_faces() > kMostFacesToCopy) return std::nullopt;
  const std::optional<size_t> open = recorder_.step();
  close();
  World before = world_;
  if (open) begin(*open);
  const size_t base = history_.base_of(*last);
  if (!history_.holds_images(base, history_.position())) return std::nullopt;
  const size_t end = history_.position(), slots = history_.slots_before(base, end);
  for (size_t i = end; i-- > base;) history_.step(i).restore(before, slots);
  return before;
}

Outcome Document::recut(const Recut& command) {
  end_stroke();
  Outcome all;
  if (can_recut() && bodies_move_in(history_.commands_of(history_.position() - 1))) all = finish(nullptr);
  if (!all.ok() || !can_recut()) return all;
  begin_step(command);
  journal_.append(command);
  ++revision_;
  all.delta.append(cut_again());
  return all;
}

// Of the last step: the world goes back to before the stroke as an edit of its own. A stroke of which moves
// wait, and under which bodies do not move, is taken back for good: whoever undoes the recut has it walked
// again.
Delta Document::cut_again() {
  const size_t step = history_.position() - 1, before = step - 1;
  queue_.drop(before);
  if (recorder_.step() == before) close();
  physics_ = Physics();
  Delta delta;
  if (!history_.step(before).done()) {
    delta = history_.step(before).take_back(world_);
    history_.step(before).forget();
  }
  // Where the world shows nothing of the stroke, an earlier one may wait, half-way through a move.
  const size_t base = history_.base_of(step);
  if (history_.any_begun(base, step)) begin(step);
  const size_t slots = history_.slots_before(base, step);
  for (size_t i = step; i-- > base;) {
    const Delta back = history_.step(i).restore(world_, slots);
    history_.last().touch(back);
    delta.append(back);
  }
  // As where the stroke itself begins.
  if (recorder_.step() == step) forget_details(world_);
  queue_commands(step);
  history_.trim();
  return delta;
}

// Has what the last step queued walked as if it had just been drawn.
Delta Document::walk_again() {
  if (history_.last().kind() == Kind::kRecut) return cut_again();
  queue_commands(history_.position() - 1);
  return Delta{};
}

bool Document::can_start_again() const {
  const size_t now = history_.position();
  return now > 0 && history_.cuts(now - 1) && history_.holds_images(history_.base_of(now - 1), now);
}

Delta Document::start_again() {
  KERF_ASSERT(can_start_again());
  const size_t last = history_.position() - 1;
  if (recorder_.step() == last) close();
  queue_.drop(last);
  physics_ = Physics();
  Delta delta = history_.step(last).take_back(world_);
  history_.step(last).forget();
  delta.append(walk_again());
  ++revision_;
  return delta;
}

std::optional<Document::Mark> Document::mark() {
  const size_t position = history_.position();
  if (in_stroke_ || position == 0 || recorder_.step() != position - 1 || rim_is_unfinished())
    return std::nullopt;
  const HistoryStep& last = history_.step(position - 1);
  if (last.images() != Images::kHeld) return std::nullopt;
  close();
  Mark mark{revision_, position, last.mark(), queue_, walked_, walked_ ? walked_->path.size() : 0};
  begin(position - 1);
  return mark;
}

bool Document::can_go_back_to(const Mark& mark) const {
  return !in_stroke_ && mark.revision == revision_ && mark.position == history_.position() &&
         history_.step(mark.position - 1).can_go_back_to(mark.step);
}

Delta Document::go_back_to(const Mark& mark) {
  KERF_ASSERT(can_go_back_to(mark));
  close();
  Delta delta = history_.step(mark.position - 1).go_back_to(mark.step, world_);
  queue_ = mark.queue;
  walked_ = mark.stroke;
  if (walked_) walked_->path.resize(mark.moves);
  begin(mark.position - 1);
  physics_ = Physics();
  ++revision_;
  return delta;
}

// Whether the world can be brought to where a step begins by before-images.
bool Document::can_walk_again(size_t step) const {
  return history_.holds_images(history_.base_of(step), step);
}

// Executes what waits if that is only a little time. A step that is done when it is undone can be done again
// by its images.
Outcome Document::pass_last_ticks() {
  constexpr size_t kFewTicks = 24;
  const bool few = only_cools() || (!queue_.holds_beam() && queue_.size() <= kFewTicks && !must_separate());
  return few ? finish(nullptr) : Outcome();
}

Outcome Document::undo(const Progress* progress) {
  end_stroke();
  Outcome passed = pass_last_ticks();
  if (history_.position() == 0) return Outcome();
  const size_t last = history_.position() - 1;
  if (recorder_.step() == last) close();
  HistoryStep& step = history_.step(last);
  // The step before was taken back for good where it was cut again.
  const bool again = last > 0 && history_.step(last - 1).waiting() && !queue_.holds(last - 1);
  if (step.images() == Images::kLetGo || (again && !can_walk_again(last - 1))) return replay(last, progress);
  queue_.drop(last);
  physics_ = Physics();
  Delta delta = std::move(passed.delta);
  delta.append(step.take_back(world_));
  if (!step.done()) step.forget();
  history_.back();
  if (again) delta.append(walk_again());
  history_.trim();
  journal_.append(Undo{});
  ++revision_;
  return Outcome(std::move(delta));
}

Outcome Document::redo(const Progress* progress) {
  end_stroke();
  if (history_.position() == history_.size()) return Outcome();
  const size_t at = history_.position();
  HistoryStep& step = history_.step(at);
  Outcome outcome;
  if (step.images() == Images::kHeld && step.done() && queue_.empty()) {
    close();
    physics_ = Physics();
    outcome.delta = step.bring_again(world_);
    history_.forth();
  } else if (step.kind() == Kind::kEdit) {
    outcome = redo_at_once(at, progress);
    if (!outcome.ok()) return outcome;
  } else {
    if (!can_walk_again(at)) return replay(at + 1, progress);
    step.forget();
    history_.forth();
    outcome.delta = walk_again();
  }
  journal_.append(Redo{});
  ++revision_;
  return outcome;
}

bool Document::remembers_way_to(size_t position) const {
  return history_.holds_images(position, history_.position());
}

Outcome Document::travel(size_t position, const Progress* progress) {
  end_stroke();
  position = std::min(position, history_.size());
  if (!remembers_way_to(position)) return replay(position, progress);
  Outcome all;
  while (all.ok() && history_.position() != position)
    all.append(history_.position() > position ? undo(progress) : redo(progress));
  return all;
}

// Starts again from the origin. Where that cannot be had, nothing has changed.
Outcome Document::replay(size_t position, const Progress* progress) {
  Outcome outcome;
  if (!origin_) {
    outcome.fail(failed("what the world was then is no longer remembered"));
    return outcome;
  }
  const Progress loading = share_of(progress, 0, 0.3), walking = share_of(progress, 0.3, 1);
  Result<World> origin = origin_(&loading);
  if (!origin) {
    outcome.fail(origin.error());
    return outcome;
  }
  world_ = std::move(*origin);
  queue_.clear();
  recorder_.abandon();
  physics_ = Physics();
  ++revision_;
  const size_t before = history_.position(), written = journal_.size();
  while (history_.position() > 0) history_.back();
  for (size_t i = 0; i < history_.size(); ++i) history_.step(i).forget();
  outcome.delta.anew = true;
  if (const Status done = replay_steps(position, &walking); !done) outcome.fail(done.error());
  journal_.shrink(written);
  for (size_t i = history_.position(); i < before; ++i) journal_.append(Undo{});
  for (size_t i = before; i < history_.position(); ++i) journal_.append(Redo{});
  return outcome;
}

// A stroke that is cut again right away need not be cut first, unless bodies move under it. Then it is cut,
// and its before-images are kept until it has been cut again.
Status Document::replay_steps(size_t position, const Progress* progress) {
  const size_t window = history_.window();
  while (history_.position() < position) {
    const size_t step = history_.position();
    const double share = 1 / static_cast<double>(position), from = share * static_cast<double>(step);
    const Progress walking = share_of(progress, from, from + share);
    Outcome done;
    if (history_.step(step).kind() == Kind::kEdit) {
      done = redo_at_once(step, &walking);
      if (done.ok()) done = finish(&walking);
    } else {
      history_.forth();
      const bool again = step + 1 < position && history_.step(step + 1).kind() == Kind::kRecut;
      if (again && !bodies_move_in(history_.commands_of(step))) continue;
      if (again) history_.set_window(std::numeric_limits<size_t>::max());
      walk_again();
      done = finish(&walking);
      if (!again || !done.ok()) history_.set_window(window);
    }
    if (!done.ok()) return done.error();
  }
  return Done{};
}

}  // namespace kerf
