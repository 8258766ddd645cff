#include "core/document/execution.h"

#include <algorithm>

#include "core/base/assert.h"
#include "core/base/number_format.h"
#include "core/cut/cut_step.h"
#include "core/document/edit_piece.h"
#include "core/physics/sleep.h"

namespace kerf {

namespace {

// Loading a mesh and writing its pieces takes 260 bytes per face, and a stroke 130 bytes per face that it
// makes; before-images and rendering take as much again.
constexpr uint64_t kBytesAFace = 400;
constexpr size_t kMinBudget = 100'000;

}  // namespace

size_t usual_face_budget(uint64_t memory) {
  return std::clamp<uint64_t>(memory / kBytesAFace, kMinBudget, CutSettings::kMaxFaces);
}

Error over_face_budget(size_t budget) {
  return failed(
      "the cut would make more than " + grouped(budget) +
      " faces, more than the memory of this machine holds: use a coarser resolution or a shorter stroke");
}

using Images = HistoryStep::Images;
using Kind = HistoryStep::Kind;

// Queueing --------------------------------------------------------------------------------------------------

void Execution::enqueue(size_t step, const Command& command) {
  const auto move_to = [&](const BeamAt& next) {
    const BeamMove move{drawn_->beam.pose, next.pose, next.time - drawn_->beam.time};
    if (!drawn_->given_up) queue_.push_move(step, drawn_, move, world_);
    drawn_->beam = next;
  };
  std::visit(Overloaded{
                 [&](const BeginStroke& c) {
                   drawn_ = std::make_shared<Stroke>();
                   drawn_->settings = c.settings;
                   drawn_->beam = {c.pose, 0};
                   move_to({c.pose, 0});
                 },
                 [&](const MoveBeam& c) {
                   move_to({c.pose, c.time});
                 },
                 [&](const EndStroke&) {
                   drawn_->ended = true;
                   if (drawn_->settings.smooth() && !drawn_->given_up) queue_.push_rim(step, drawn_);
                 },
                 [&](const StopStroke& c) { queue_.stop(step, c, world_); },
                 [&](const AdvanceTime& c) {
                   const bool beam = c.bodies && drawn_ && !drawn_->ended && !drawn_->given_up;
                   queue_.push_ticks(step, c.ticks, c.bodies, beam ? drawn_ : nullptr);
                 },
                 [&](const DragBody& c) {
                   queue_.push_spring(step, Spring{c.piece, c.at, c.to});
                 },
                 [&](const ReleaseBody&) { queue_.push_spring(step, std::nullopt); },
                 [&](const Play&) {},
                 [&](const Recut&) { KERF_ASSERT(!"queued by the commands of its stroke"); },
                 [&](const Undo&) { KERF_ASSERT(!"never part of a step"); },
                 [&](const Redo&) { KERF_ASSERT(!"never part of a step"); },
                 [&](const ImmediateCommand auto&) { KERF_ASSERT(!"immediate"); },
             },
             command);
}

void Execution::enqueue_all(size_t step) {
  for (const Command& c : history_.commands_of(step)) enqueue(step, c);
}

void Execution::enqueue_time_of_edit(size_t step) {
  HistoryStep& edit = history_.step(step);
  if (edit.commands().size() == 1) return;
  for (size_t i = 1; i < edit.commands().size(); ++i) enqueue(step, edit.commands()[i]);
  edit.reopen();
}

std::optional<StopStroke> Execution::stop_here() const {
  const size_t now = history_.position();
  if (now == 0 || !history_.cuts(now - 1) || !queue_.holds_moves(now - 1)) return std::nullopt;
  return queue_.reached(now - 1);
}

void Execution::stop(const StopStroke& there) {
  const size_t last = history_.position() - 1;
  queue_.stop(last, there, world_);
  if (!history_.last().waiting()) finish(last);
}

bool Execution::only_a_few_ticks_wait() const {
  constexpr size_t kFewTicks = 24;
  return only_cools() || (!queue_.holds_beam() && queue_.size() <= kFewTicks && !must_separate());
}

// Immediate commands ---------------------------------------------------------------------------------------

Result<Delta> Execution::run(HistoryStep& step, size_t at, const Progress* progress) {
  close_and_trim();
  step.begin(history_.window() > 0);
  recorder_.open(world_, at, history_.window() > 0);
  Result<Delta> delta =
      std::visit(Overloaded{
                     [&](ImmediateCommand auto& c) { return c.run(world_, step.generation, progress); },
                     [&](const auto&) -> Result<Delta> {
                       KERF_ASSERT(!"not an immediate command");
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

// Going back ------------------------------------------------------------------------------------------------

Delta Execution::undo(size_t step) {
  if (recorder_.step() == step) close();
  queue_.drop(step);
  physics_ = Physics();
  return history_.step(step).undo(world_);
}

Delta Execution::redo(size_t step) {
  close();
  physics_ = Physics();
  return history_.step(step).redo(world_);
}

Delta Execution::cut_again() {
  const size_t step = history_.position() - 1, before = step - 1;
  queue_.drop(before);
  if (recorder_.step() == before) close();
  physics_ = Physics();
  Delta delta;
  if (!history_.step(before).done()) {
    delta = history_.step(before).undo(world_);
    history_.step(before).forget();
  }
  delta.append(restore_what_is_cut_again(step));
  enqueue_all(step);
  history_.trim();
  return delta;
}

// Restores the world before the stroke that a recut cuts again, as a part of the recut.
Delta Execution::restore_what_is_cut_again(size_t recut) {
  // If nothing of the stroke was executed, an earlier one may be queued, half-way through a move.
  const size_t base = history_.base_of(recut);
  if (history_.any_begun(base, recut)) begin(recut);
  const size_t slots = history_.slots_before(base, recut);
  Delta delta;
  for (size_t i = recut; i-- > base;) {
    const Delta back = history_.step(i).restore(world_, slots);
    history_.step(recut).touch(back);
    delta.append(back);
  }
  // Discards details of contacts, as the start of the stroke itself does.
  if (recorder_.step() == recut) forget_details(world_);
  return delta;
}

Delta Execution::run_again() {
  if (history_.last().kind() == Kind::kRecut) return cut_again();
  enqueue_all(history_.position() - 1);
  return Delta{};
}

bool Execution::can_run_again(size_t step) const {
  return history_.holds_images(history_.base_of(step), step);
}

std::optional<World> Execution::copy_before(size_t base) {
  const std::optional<size_t> open = recorder_.step();
  close();
  World before = world_;
  if (open) begin(*open);
  const size_t end = history_.position();
  if (!history_.holds_images(base, end)) return std::nullopt;
  const size_t slots = history_.slots_before(base, end);
  for (size_t i = end; i-- > base;) history_.step(i).restore(before, slots);
  return before;
}

void Execution::start_with(World world) {
  world_ = std::move(world);
  queue_.clear();
  recorder_.abandon();
  physics_ = Physics();
  while (history_.position() > 0) history_.back();
  for (size_t i = 0; i < history_.size(); ++i) history_.step(i).forget();
}

std::optional<Execution::Mark> Execution::mark() {
  const size_t last = history_.position() - 1;
  if (in_stroke() || recorder_.step() != last || rim_is_unfinished()) return std::nullopt;
  if (history_.last().images() != Images::kHeld) return std::nullopt;
  close();
  Mark mark{history_.last().mark(), queue_, walked_, walked_ ? walked_->path.size() : 0};
  begin(last);
  return mark;
}

Delta Execution::go_back_to(const Mark& mark) {
  close();
  Delta delta = history_.last().go_back_to(mark.step, world_);
  queue_ = mark.queue;
  walked_ = mark.stroke;
  if (walked_) walked_->path.resize(mark.moves);
  begin(history_.position() - 1);
  physics_ = Physics();
  return delta;
}

}  // namespace kerf
