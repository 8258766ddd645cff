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
#include "core/document/history.h"
#include "core/physics/physics.h"
#include "core/world/rigid_body.h"
#include "core/world/world.h"

namespace kerf {

// The number of faces, live and removed ones, that so much memory (bytes) is enough for, with the tree, the
// before-images of strokes and what the program holds beside; see Document::set_face_budget.
size_t usual_face_budget(uint64_t memory);

// The error of a stroke that makes more faces than the budget.
Error over_face_budget(size_t budget);

// Records the before-images of the step of the history that is being executed, which is called open.
class Recorder {
 public:
  // The open step, or nothing between close() and open().
  std::optional<size_t> step() const { return step_; }

  // Opens a step: changes from now on belong to it, and with `record` their before-images are recorded.
  // Precondition: no step is open.
  void open(World& world, size_t step, bool record) {
    KERF_ASSERT(!step_);
    step_ = step;
    recording_ = record;
    if (record) world.begin_change();
  }
  // Closes the open step and returns the changes since open() if they were recorded. Preconditions: a step is
  // open, and `world` is the one for which it was opened.
  std::optional<World::Change> close(World& world) {
    KERF_ASSERT(step_);
    step_.reset();
    return recording_ ? std::optional(world.end_change()) : std::nullopt;
  }
  // Discards the recording, because the world was replaced by another one.
  void abandon() { step_.reset(); }

 private:
  std::optional<size_t> step_;
  bool recording_ = false;
};

// Executes the steps of a history on a world, and records before-images of what each changes. Commands in
// time are queued and executed in bounded parts; the others are executed at once.
//
// The result depends neither on the division into parts nor on when the queue runs empty: the same faces are
// removed, and the same pieces are separated, with the same labels. A tick starts when the moves before it
// have been executed and the search for separated pieces is finished. Bodies move in the ticks of AdvanceTime
// commands that say so: pieces that came off become bodies first (see release_pieces), and what touched a
// body that was changed wakes (see forget_contacts).
class Execution {
 public:
  Execution() = default;
  explicit Execution(World world) : world_(std::move(world)) {}

  const World& world() const { return world_; }
  // The physics of the bodies, with the contacts and statistics of the last tick in which they moved.
  const Physics& physics() const { return physics_; }
  const History& history() const { return history_; }
  History& history() { return history_; }

  // What waits --------------------------------------------------------------------------------------------

  // The length of the queue: moves (including one that is partly executed), ticks, changes of the spring, and
  // ends of strokes with a smooth rim (see BeamQueue::size). At least 1 while no stroke is running and a
  // search for separated pieces is not finished.
  size_t waiting() const;
  bool queue_is_empty() const { return queue_.empty(); }
  // Whether the queue holds moves or ends of strokes, not only ticks and searches.
  bool beam_waits() const { return queue_.holds_beam(); }
  // Whether the queue holds moves.
  bool moves_wait() const { return queue_.holds_moves(); }
  // Whether the queue holds anything of a step of the history.
  bool waits_for(size_t step) const { return queue_.holds(step); }
  // Whether the queue holds only ticks in which bodies stand still, so that nothing changes but heat.
  bool only_cools() const { return queue_.only_cools() && !must_separate(); }
  // Whether the whole queue is a little time.
  bool only_a_few_ticks_wait() const;
  // Whether a stroke was begun and not ended.
  bool in_stroke() const { return drawn_ && !drawn_->ended; }
  // The command that ends the last stroke where it is. Nothing if no moves of it wait.
  std::optional<StopStroke> stop_here() const;
  // The first move that the next step executes, or nothing if it executes none.
  std::optional<BeamMove> next_move() const { return queue_.next_move(world_); }
  // The settings of the stroke of that move. Precondition: there is one.
  const CutSettings& next_settings() const { return queue_.front_stroke()->settings; }
  // Whether the next step is a part of the search for separated pieces.
  bool next_searches() const { return must_separate(); }
  // Whether the next step ends a stroke with a smooth rim, or goes on with that.
  bool next_closes_rim() const;
  // Whether the last step left the end of a stroke unfinished.
  bool rim_is_unfinished() const { return queue_.unfinished_rim().begun(); }
  // How far the first move of the queue has been executed.
  const UnfinishedMove& unfinished_move() const { return queue_.unfinished(); }
  // The number of faces that the next step makes ready to move: those of bodies that pieces came off, and of
  // bodies that have changed since bodies moved last. Its cost is proportional to them. 0 if bodies do not
  // move in it.
  size_t next_makes_ready() const;
  // Whether the next step executes work of the last step of the history, not of an earlier one.
  bool next_is_of_last_step() const;
  // The step of the history whose work the next step executes. Precondition: the queue is not empty.
  size_t next_step() const { return queue_.front_step(); }

  // Queueing ----------------------------------------------------------------------------------------------

  // Queues what a command of a step of the history asks for that does not happen at once.
  void enqueue(size_t step, const Command& command);
  // Queues the work of a whole step (see History::commands_of).
  void enqueue_all(size_t step);
  // Queues the time that belongs to an edit.
  void enqueue_time_of_edit(size_t step);
  // Ends the stroke that is the last step of the history at a place that its beam has not passed.
  void stop(const StopStroke& there);

  // Executing ---------------------------------------------------------------------------------------------

  // Executes a bounded part of the queue (see Document::step and step_stage). After a failure, give_up() has
  // to be called.
  Result<StepResult> step(size_t most, bool one_stage, const Progress& progress);
  // No part of a stroke is executed while the bodies have more face slots than this.
  void set_face_budget(size_t slots) { face_budget_ = slots; }
  bool is_over_budget() const { return world_.face_slots() > face_budget_; }

  // Ends a step of which a part failed: its stroke has cut nothing, and only its time passes. With `stopped`
  // all of it is taken back, and the queue behind it is dropped. Returns false if no before-images of the
  // step are held, so that its stroke ends where it has come to. A stroke that is still running goes on
  // without effect. Precondition: with `stopped` no stroke is running.
  bool give_up(size_t step, bool stopped);
  // Ends a step, and its recording, if nothing of it waits and nothing can be added to it.
  void finish(size_t step);

  // Runs the command of a step that happens at once, and that stands, or will stand, at `at` in the history.
  // On failure the world is as it was. Precondition: nothing waits.
  Result<Delta> run(HistoryStep& step, size_t at, const Progress* progress);

  // Puts bodies where a journal says that they came (see Document::take_states and skip_to).
  StepResult take_states(std::span<const BodyState> states, std::span<const NearPair> pairs);
  StepResult skip_to(std::span<const BodyState> states, std::span<const NearPair> pairs);

  // The ticks after which details of contacts are forgotten (see forget_details), so that the state that a
  // journal gives of a full minute decides alone how bodies move on. They are also forgotten where a step
  // begins.
  static constexpr Ticks kTicksToForget = 60 * kTicksPerSecond;

  // Going back --------------------------------------------------------------------------------------------

  // Takes a step out of the world and what waits of it out of the queue, by its before-images. Precondition:
  // they are held, and all later steps are taken back.
  Delta undo(size_t step);
  // Brings a step back that was done when it was taken back. Precondition: the queue is empty, and the images
  // of the step are held.
  Delta redo(size_t step);
  // Takes the stroke that a recut, the last step of the history, cuts again out of the world as an edit of
  // the recut, and queues its commands with other settings. A stroke of which moves wait is taken back for
  // good: whoever undoes the recut has it executed again.
  Delta cut_again();
  // Queues the work of the last step of the history as if it had just been drawn.
  Delta run_again();
  // Whether the world can be brought to where a step begins by before-images.
  bool can_run_again(size_t step) const;
  // A copy of the world as it was before the steps base .. end - 1, the last of the history. Nothing if their
  // images are not held.
  std::optional<World> copy_before(size_t base);
  // Starts with another world, in which nothing of the history has been executed.
  void start_with(World world);

  // A place in the execution of the last step of the history.
  struct Mark {
    HistoryStep::Mark step;
    BeamQueue queue;
    std::shared_ptr<Stroke> stroke;
    size_t moves = 0;  // of its path
  };
  // Nothing where Document::mark() says so. Precondition: the history has a last step.
  std::optional<Mark> mark();
  Delta go_back_to(const Mark& mark);

  // Ends the recording of the open step, if there is one, and lets the history keep within its window.
  void close_and_trim();

 private:
  bool must_separate() const;
  StepResult separate_more();
  Result<StepResult> run_moves(size_t most, bool one_stage, const Progress& progress);
  Result<StepResult> close_rim_of_stroke(const Progress& progress);
  Result<StepResult> pass_ticks(size_t most, const Progress& progress);
  Result<StepResult> move_bodies(size_t step, const Progress& progress);
  Result<StepResult> move_under_beam(size_t step, const Progress& progress);
  StepResult change_spring();
  void pass(Ticks ticks);
  void enqueue_in_front(size_t step, const Command& command);

  Delta restore_what_is_cut_again(size_t recut);

  void begin(size_t step);
  // Ends the recording of the open step without trimming the history, because the images of a step that is
  // about to be taken back must be kept.
  void close();
  void keep_open(size_t step);
  void note(size_t step, const StepResult& some);
  void record_cut(size_t step, const StepResult& some);
  Result<StepResult> noted(size_t step, Result<StepResult> some);
  bool is_over(size_t step) const;
  bool is_last(size_t step) const { return step + 1 == history_.position(); }

  World world_;
  size_t face_budget_ = std::numeric_limits<size_t>::max();
  History history_;
  BeamQueue queue_;
  Recorder recorder_;
  Physics physics_;
  std::shared_ptr<Stroke> drawn_;   // the last stroke that was appended to the queue
  std::shared_ptr<Stroke> walked_;  // the last stroke that was executed
};

}  // namespace kerf
