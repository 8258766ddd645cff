#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <memory>
#include <optional>
#include <span>

#include "core/base/assert.h"
#include "core/base/result.h"
#include "core/document/beam_queue.h"
#include "core/document/undo_stack.h"
#include "core/physics/physics.h"
#include "core/world/rigid_body.h"
#include "core/world/world.h"

namespace kerf {

// Estimates the number of face slots, for live and removed faces, that fit into this memory [bytes] together
// with the tree, the before-images of strokes and the rest of the program; see Document::set_face_budget.
size_t usual_face_budget(uint64_t memory);

Error over_face_budget(size_t budget);

// Records the before-images of the open step, i.e. the history step being executed.
class Recorder {
 public:
  // The open step; nullopt between close() and open().
  std::optional<size_t> step() const { return step_; }

  // Opens a step, to which all changes until close() belong; `record`: records their before-images;
  // `only_adds`: see World::begin_change. Precondition: no step is open.
  void open(World& world, size_t step, bool record, bool only_adds = false) {
    KERF_ASSERT(!step_);
    step_ = step;
    recording_ = record;
    if (record) world.begin_change(only_adds);
  }
  // Closes the open step and returns the changes since open() if they were recorded. Preconditions: a step
  // is open, and `world` is that of open().
  std::optional<World::Change> close(World& world) {
    KERF_ASSERT(step_);
    step_.reset();
    return recording_ ? std::optional(world.end_change()) : std::nullopt;
  }
  // Discards the recording, because the world was replaced.
  void abandon() { step_.reset(); }

 private:
  std::optional<size_t> step_;
  bool recording_ = false;
};

// Executes the steps of a history on a world, and records before-images of their changes. Timed commands and
// those of strokes are queued and executed in bounded parts; other commands execute immediately.
//
// The result (removed faces, separated pieces and their labels) does not depend on the division into parts,
// nor on the times at which the queue becomes empty. A tick starts when the moves before it have been
// executed and the search for separated pieces has finished. Bodies move in the ticks of AdvanceTime commands
// with `bodies`: first, separated pieces become bodies (see release_pieces), and bodies that touched a
// changed body wake (see forget_contacts).
class CommandQueue {
 public:
  CommandQueue() = default;
  explicit CommandQueue(World world) : world_(std::move(world)) {}

  const World& world() const { return world_; }
  // The physics of the bodies, with the contacts and statistics of the last tick in which they moved.
  const Physics& physics() const { return physics_; }
  const UndoStack& history() const { return history_; }
  UndoStack& history() { return history_; }

  // Queue -------------------------------------------------------------------------------------------------

  // The queued moves, ends of strokes, ticks and changes of the spring, without searches.
  const BeamQueue& pending() const { return pending_; }
  // The length of the queue: moves (including a partly executed one), ticks, spring changes, and ends of
  // strokes with a smooth rim (see BeamQueue::size). If no stroke is running and a search for separated
  // pieces is unfinished, at least 1.
  size_t waiting() const;
  // Returns true if the queue holds only ticks in which bodies stand still, so that only heat changes.
  bool only_cools() const { return pending_.only_cools() && !next_searches(); }
  bool in_stroke() const { return drawn_ && !drawn_->ended; }
  // The command that ends the last stroke at its current place; nullopt if none of its moves is queued.
  std::optional<StopStroke> stop_here() const;

  // Returns true if the next step searches for separated pieces, before everything that is pending.
  bool next_searches() const;
  // The number of faces that the next step prepares for motion: those of bodies with pieces to detach, and of
  // bodies that have changed since bodies last moved. The cost of the step is proportional to it. 0 if no
  // bodies move in the step.
  size_t next_prepared_faces() const;
  // Returns true if the next step executes work of the last history step, not of an earlier one.
  bool next_is_of_last_step() const;

  // Queues the work of a command of a history step that does not execute immediately.
  void enqueue(size_t step, const Command& command);

  // Execution ---------------------------------------------------------------------------------------------

  // Executes a bounded part of the queue (see Document::step and step_stage). After a failure, call
  // give_up().
  Result<StepResult> step(size_t most, bool one_stage, const Progress& progress);
  // Sets the number of face slots of all bodies above which no part of a stroke is executed.
  void set_face_budget(size_t slots) { face_budget_ = slots; }
  bool is_over_budget() const { return world_.face_slots() > face_budget_; }

  // Ends a step after one of its parts failed: undoes its stroke, so that only its time passes. With
  // `stopped`, undoes all of the step and drops the queue behind it. Returns false if before-images of the
  // step were discarded; its stroke then ends at its current place. A stroke that is still running continues
  // without effect. Precondition: with `stopped`, no stroke is running.
  bool give_up(size_t step, bool stopped);
  // Ends a step and its recording, unless parts of it are queued or commands can still be added to it.
  void finish(size_t step);

  // Executes the immediate command of a step that is, or will be inserted, at position `at` of the history.
  // On failure the world is unchanged. Precondition: the queue is empty.
  Result<Delta> run(HistoryStep& step, size_t at, const Progress* progress);

  // Sets bodies to the states that a journal recorded (see Document::set_states).
  StepResult set_states(std::span<const BodyState> states, std::span<const NearPair> pairs);

  // The interval at which contact details are discarded (see forget_details), so that the state that a
  // journal records at a full minute fully determines the further motion. They are also discarded at the
  // start of each step.
  static constexpr Ticks kTicksToForget = 60 * kTicksPerSecond;

  // Undo and redo -----------------------------------------------------------------------------------------

  // Undoes a step by its before-images and removes its work from the queue. Preconditions: the images are
  // held, and all later steps are undone.
  Delta undo(size_t step);
  // Redoes a step that had been complete when it was undone. Preconditions: the queue is empty, and the
  // images of the step are held.
  Delta redo(size_t step);
  // Queues the work of the last history step again, as if its commands had just been applied. A recut first
  // undoes the stroke that it cuts again, as an edit of its own. If that stroke still has queued moves, its
  // images are dropped: undoing the recut has to execute the stroke again. Precondition: before-images can
  // restore the world at the start of the step.
  Delta run_again();
  // Copies the world as it was before the steps base .. end - 1, the last of the history; nullopt if their
  // images are not held.
  std::optional<World> copy_before(size_t base);
  // Replaces the world by one in which no step of the history has been executed.
  void start_with(World world);

  // A save point in the execution of the last history step.
  struct SavePoint {
    HistoryStep::SavePoint step;
    BeamQueue pending;
    std::shared_ptr<Stroke> stroke;
    size_t moves = 0;  // of its path
  };
  // Creates a save point; nullopt in the cases of Document::SavePoint::create(). Precondition: the history
  // has a last step.
  std::optional<SavePoint> save_point();
  Delta restore(const SavePoint& point);

  // Ends the recording of the open step, if any, and trims the history to its window.
  void close_and_trim();

 private:
  StepResult separate_more();
  Result<StepResult> run_moves(size_t most, bool one_stage, const Progress& progress);
  Result<StepResult> close_rim_of_stroke(const Progress& progress);
  Result<StepResult> pass_ticks(size_t most, const Progress& progress);
  Result<StepResult> move_bodies(size_t step, const Progress& progress);
  Result<StepResult> move_under_beam(size_t step, const Progress& progress);
  StepResult change_spring();
  void pass(Ticks ticks);
  void enqueue_in_front(size_t step, const Command& command);

  void enqueue_all(size_t step);
  Delta cut_again();
  Delta undo_strokes_of(size_t recut);

  void begin(size_t step);
  // Ends the recording of the open step without trimming the history, which keeps the images of a step to be
  // undone next.
  void close();
  void keep_open(size_t step);
  void record_cut(size_t step, const StepResult& some);
  Result<StepResult> recorded(size_t step, Result<StepResult> some);
  bool is_over(size_t step) const;
  bool is_last(size_t step) const { return step + 1 == history_.position(); }

  World world_;
  size_t face_budget_ = std::numeric_limits<size_t>::max();
  UndoStack history_;
  BeamQueue pending_;
  Recorder recorder_;
  Physics physics_;
  std::shared_ptr<Stroke> drawn_;   // the last stroke that was queued
  std::shared_ptr<Stroke> walked_;  // the last stroke that was executed
};

}  // namespace kerf
