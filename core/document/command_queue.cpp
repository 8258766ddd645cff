#include "core/document/command_queue.h"

#include <algorithm>

#include "core/base/assert.h"
#include "core/base/number_format.h"
#include "core/cut/cut_step.h"
#include "core/document/extract.h"
#include "core/physics/sleep.h"

namespace kerf {

namespace {

// Loading a mesh and writing its pieces takes 260 bytes per face, and a stroke 130 bytes per face that it
// makes; before-images and rendering take as much again.
constexpr uint64_t kBytesAFace = 400;
constexpr size_t kMinBudget = 100'000;

// Returns the number of body slots of the world before the first of the steps first .. end - 1 that holds
// before-images; 0 if none does.
size_t slots_before(const UndoStack& history, size_t first, size_t end) {
  for (size_t i = first; i < end; ++i) {
    if (const auto slots = history.step(i).slots_before()) return *slots;
  }
  return 0;
}

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

// Queue -----------------------------------------------------------------------------------------------------

void CommandQueue::enqueue(size_t step, const Command& command) {
  const auto move_to = [&](const BeamAt& next) {
    KERF_ASSERT(drawn_ != nullptr);
    const BeamMove move{drawn_->beam.pose, next.pose, next.time - drawn_->beam.time};
    if (!drawn_->given_up) pending_.push_move(step, drawn_, move, world_);
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
                   if (drawn_->settings.smooth() && !drawn_->given_up) pending_.push_rim(step, drawn_);
                 },
                 [&](const StopStroke& c) { pending_.stop(step, c, world_); },
                 [&](const AdvanceTime& c) {
                   const bool beam = c.bodies && drawn_ && !drawn_->ended && !drawn_->given_up;
                   pending_.push_ticks(step, c.ticks, c.bodies, beam ? drawn_ : nullptr);
                 },
                 [&](const DragBody& c) {
                   pending_.push_spring(step, Spring{c.piece, c.at, c.to});
                 },
                 [&](const ReleaseBody&) { pending_.push_spring(step, std::nullopt); },
                 [&](const Play&) {},
                 [&](const Recut&) { KERF_ASSERT(!"queued by the commands of its stroke"); },
                 [&](const Undo&) { KERF_ASSERT(!"never part of a step"); },
                 [&](const Redo&) { KERF_ASSERT(!"never part of a step"); },
                 [&](const ImmediateCommand auto&) { KERF_ASSERT(!"immediate"); },
             },
             command);
}

void CommandQueue::enqueue_all(size_t step) {
  for (const Command& c : history_.commands_of(step)) enqueue(step, c);
}

std::optional<StopStroke> CommandQueue::stop_here() const {
  const size_t now = history_.position();
  if (now == 0 || !history_.cuts(now - 1) || !pending_.holds_moves(now - 1)) return std::nullopt;
  return pending_.reached(now - 1);
}

// Immediate commands ---------------------------------------------------------------------------------------

Result<Delta> CommandQueue::run(HistoryStep& step, size_t at, const Progress* progress) {
  KERF_ASSERT(pending_.empty() && !step.commands().empty());
  close_and_trim();
  step.begin(history_.window() > 0);
  recorder_.open(world_, at, history_.window() > 0, std::holds_alternative<AddMesh>(step.commands().front()));
  Result<Delta> delta = Delta{};
  try {
    delta = std::visit(
        Overloaded{
            [&](const ImmediateCommand auto& c) { return c.run(world_, step.generation, progress); },
            [&](const auto&) -> Result<Delta> {
              KERF_ASSERT(!"not an immediate command");
              return Delta{};
            },
        },
        step.commands().front());
    if (delta) {
      forget_contacts(world_, *delta);
      follow_with_spring(world_, *delta);
    }
  } catch (...) {
    if (std::optional<World::Change> change = recorder_.close(world_)) world_.exchange(*change);
    step.forget();
    physics_ = Physics();
    throw;
  }
  std::optional<World::Change> change = recorder_.close(world_);
  if (!delta) {
    step.forget();
    return delta;
  }
  if (change) step.add(std::move(*change));
  step.record(*delta);
  step.finish();
  physics_.follow(*delta);
  return delta;
}

// Undo and redo ---------------------------------------------------------------------------------------------

Delta CommandQueue::undo(size_t step) {
  if (recorder_.step() == step) close();
  pending_.drop(step);
  // An earlier step that is being executed keeps its colliders (see Physics).
  if (!history_.step(step).waiting()) physics_ = Physics();
  return history_.step(step).undo(world_);
}

Delta CommandQueue::redo(size_t step) {
  close();
  physics_ = Physics();
  return history_.step(step).redo(world_);
}

Delta CommandQueue::cut_again() {
  KERF_ASSERT(history_.position() >= 2);
  const size_t step = history_.position() - 1, before = step - 1;
  pending_.drop(before);
  if (recorder_.step() == before) close();
  physics_ = Physics();
  Delta delta;
  if (!history_.step(before).done()) {
    delta = history_.step(before).undo(world_);
    history_.step(before).forget();
  }
  delta.append(undo_strokes_of(step));
  enqueue_all(step);
  history_.trim();
  return delta;
}

// Restores the world before the stroke that a recut cuts again, as a part of the recut.
Delta CommandQueue::undo_strokes_of(size_t recut) {
  // If nothing of the stroke was executed, an earlier one may be queued, half-way through a move.
  const size_t base = history_.base_of(recut);
  for (size_t i = base; i < recut; ++i) {
    if (!history_.step(i).waiting()) begin(recut);
  }
  const size_t slots = slots_before(history_, base, recut);
  Delta delta;
  for (size_t i = recut; i-- > base;) {
    const Delta back = history_.step(i).restore(world_, slots);
    history_.step(recut).record(back);
    delta.append(back);
  }
  // Discards contact details, like the start of the stroke itself.
  if (recorder_.step() == recut) forget_details(world_);
  return delta;
}

Delta CommandQueue::run_again() {
  if (history_.last().kind() == Kind::kRecut) return cut_again();
  enqueue_all(history_.position() - 1);
  return Delta{};
}

std::optional<World> CommandQueue::copy_before(size_t base) {
  KERF_ASSERT(base <= history_.position());
  const std::optional<size_t> open = recorder_.step();
  close();
  World before = world_;
  if (open) begin(*open);
  const size_t end = history_.position();
  if (!history_.holds_images(base, end)) return std::nullopt;
  const size_t slots = slots_before(history_, base, end);
  for (size_t i = end; i-- > base;) history_.step(i).restore(before, slots);
  return before;
}

void CommandQueue::start_with(World world) {
  world_ = std::move(world);
  pending_.clear();
  recorder_.abandon();
  physics_ = Physics();
  history_.set_position(0);
  for (size_t i = 0; i < history_.size(); ++i) history_.step(i).forget();
}

std::optional<CommandQueue::SavePoint> CommandQueue::save_point() {
  KERF_ASSERT(history_.position() > 0);
  const size_t last = history_.position() - 1;
  if (in_stroke() || recorder_.step() != last || pending_.unfinished_rim().begun()) return std::nullopt;
  if (history_.last().images() != Images::kHeld) return std::nullopt;
  close();
  SavePoint point{HistoryStep::SavePoint(history_.last()), pending_, walked_,
                  walked_ ? walked_->path.size() : 0};
  begin(last);
  return point;
}

Delta CommandQueue::restore(const SavePoint& point) {
  close();
  Delta delta = point.step.restore(history_.last(), world_);
  pending_ = point.pending;
  walked_ = point.stroke;
  if (walked_) {
    walked_->path.resize(point.moves);
    walked_->list_path(world_);
  }
  begin(history_.position() - 1);
  physics_ = Physics();
  return delta;
}

}  // namespace kerf
