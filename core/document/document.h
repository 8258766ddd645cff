#pragma once

#include <functional>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "core/base/assert.h"
#include "core/base/result.h"
#include "core/document/command_log.h"
#include "core/document/command_queue.h"
#include "core/world/rigid_body.h"
#include "core/world/world.h"

namespace kerf {

// The result of a command: the changes to the world, and the error if the command failed. The delta may be
// non-empty on failure, because the queue of the document is executed before the command.
class Outcome {
 public:
  Outcome() = default;
  explicit Outcome(Delta changed) : delta(std::move(changed)) {}

  Delta delta;

  bool ok() const { return !error_; }
  explicit operator bool() const { return ok(); }
  // Precondition: !ok().
  const Error& error() const {
    KERF_ASSERT(error_);
    return *error_;
  }
  void fail(Error error) { error_ = std::move(error); }

  // Merges the outcome of the next command into this one. Precondition: ok().
  void append(Outcome later) {
    KERF_ASSERT(ok());
    delta.append(std::move(later.delta));
    error_ = std::move(later.error_);
  }

 private:
  std::optional<Error> error_;
};

// A world and the commands that produced it.
//
// The commands of a stroke, and AdvanceTime, append beam moves and ticks to a queue, of which step()
// executes a bounded part (see CommandQueue). All other commands execute immediately, after the whole queue.
//
// Time advances only by AdvanceTime commands. In the history, time belongs to the stroke before it: it is
// undone with the stroke and advances again when the stroke is recut. After an edit, after Play, or at the
// start of the history it is a step of its own, unless the command states that it joins the edit (see
// AdvanceTime).
//
// Undo and redo exchange the before-images that each history step recorded. They are exact to the bit and
// cost time proportional to the change. If the before-images of a step were discarded to save memory, the
// document replays its commands from the origin.
class Document {
 public:
  // Recreates the initial world of the document.
  using Origin = std::function<Result<World>(const Progress*)>;
  class SavePoint;

  Document() = default;
  explicit Document(World world, Origin origin = {}) : queue_(std::move(world)), origin_(std::move(origin)) {}

  const World& world() const { return queue_.world(); }
  const CommandQueue& queue() const { return queue_; }
  const UndoStack& history() const { return queue_.history(); }
  // From now on, undoing a step whose before-images were discarded fails.
  void drop_origin() { origin_ = {}; }
  // Sets the memory limit of the before-images (see UndoStack::set_window).
  void set_window(size_t bytes) { queue_.history().set_window(bytes); }

  // Limits the number of face slots, i.e. of live and removed faces, to what the memory of this machine
  // holds (see usual_face_budget); unlimited by default. A stroke that exceeds the limit fails as if
  // `progress` had stopped it: it is undone, in the journal too, so that the result of a replay does not
  // depend on the limit.
  void set_face_budget(size_t slots) { queue_.set_face_budget(slots); }

  // Applies the command and appends it to the journal. Every command except those of a stroke, AdvanceTime,
  // DragBody and ReleaseBody ends a running stroke. A move without a running stroke, and a command without
  // effect, are ignored and not written to the journal.
  //
  // A command that executes immediately first executes the whole queue; the outcome lists the changes of
  // both. On failure the command itself has changed nothing, but the queue has been executed, up to a step
  // of it that fails. Exception: if `progress` stops the replay that a StopStroke needs within its stroke,
  // the command takes effect and the rest of the stroke is queued.
  Outcome apply(const Command& command, const Progress* progress = nullptr);
  // Applies commands, except Undo and Redo, and executes them completely, all or nothing. First executes the
  // queue, which `progress` cannot stop. On failure, or if `progress` stops the commands, restores the world,
  // the journal and the history with its undone steps; caches of the world must then be rebuilt completely.
  Outcome run_whole(std::span<const Command> commands, const Progress* progress = nullptr);
  // Executes work that applies commands and executes them completely. First executes the queue. If the work
  // fails or throws, restores the world, the journal and the history with its undone steps; caches of the
  // world must then be rebuilt completely. Work without an effect also keeps the undone steps.
  Status all_or_nothing(const std::function<Status()>& work);

  // The length of the queue (see CommandQueue::waiting).
  size_t waiting() const { return queue_.waiting(); }

  // Executes a bounded part of the queue, one of:
  // - up to `most` moves of one stroke, limited to CutSettings::faces_per_step faces, so the last move may
  //   be left unfinished for the next step
  // - a part of the end of a stroke with a smooth rim, limited in the same way
  // - a part of the search for separated pieces, which must finish before the next stroke or tick
  // - up to `most` ticks, or one tick in which bodies move
  // - a change of the spring
  // Calling it repeatedly until waiting() is 0 executes the whole queue.
  //
  // On failure the stroke is undone; a failed recut also undoes the stroke that it replaces. Caches of the
  // world must then be rebuilt completely. If `progress` stopped the step, the stroke is also undone in the
  // journal, together with the queue behind it. If no before-images are recorded (see set_window), the stroke
  // instead ends at the place reached.
  Result<StepResult> step(size_t most, const Progress* progress = nullptr) {
    return execute(most, false, progress);
  }

  // Like step(), but executes only the next stage of a move through one body (see cut_stage), a part of the
  // end of a stroke or of the search, or one tick. The result of the stroke is the same.
  Result<StepResult> step_stage(const Progress* progress = nullptr) { return execute(1, true, progress); }

  // Undoes the last history step, a stroke or a recut, and queues its work again as if it had just been
  // applied; a stroke may still be running. The history and the journal are unchanged, and executing the
  // queue leads to the same world, to the bit. Returns the changes. Precondition: can_restart_stroke().
  Delta restart_stroke();

  // Undoes the last history step, a stroke of which parts may be queued, and removes it from the history and
  // the journal. First finishes the walls of a solid that a step left incomplete. The outcome lists all
  // changes. Fails, and keeps the stroke as executed so far, if before-images were discarded.
  // Precondition: the last history step is a stroke, and the journal holds no later command.
  Outcome cancel_stroke();

  // Removes the undone steps from the history, so that they can no longer be redone. The journal keeps their
  // commands, each undone by an Undo.
  void drop_undone() { queue_.history().drop_undone(); }

  // Returns a copy of the world before the last stroke that was not undone; nullopt if its before-images
  // were discarded or the world has more faces than can be copied between two frames.
  static constexpr size_t kMaxFacesToCopy = 400'000;
  std::optional<World> before_last_stroke();

  // A counter that increases when a stroke is begun, stopped, recut, undone or redone.
  size_t revision() const { return revision_; }

  // Sets existing bodies to the states that a journal recorded, so that their motion continues as recorded.
  // Skips the queued ticks and spring changes without simulating bodies. Belongs to the last history step and
  // is not a command. Preconditions: there is such a step, and nothing is queued; or only ticks and spring
  // changes of that step, no beam is on, and the last executed step was one of its ticks.
  StepResult set_states(std::span<const BodyState> states, std::span<const NearPair> pairs) {
    return queue_.set_states(states, pairs);
  }

  // Goes to a position of the history by undo and redo, or by a replay if before-images on the way there
  // were discarded (see UndoStack::holds_images). The outcome lists all changes, also on failure.
  Outcome travel(size_t position, const Progress* progress = nullptr);

  // All commands that were applied, including Undo and Redo.
  const std::vector<Command>& journal() const { return journal_.commands(); }
  // The number of commands that no longer change. The last one may be an AdvanceTime of less than a second,
  // which further time extends.
  size_t final_commands() const { return journal_.final_size(); }
  // Makes all commands final, so that they can be written to a file.
  void seal_journal() { journal_.seal(); }

 private:
  void begin_stroke(const BeginStroke& command);
  void move_stroke(const MoveBeam& command);
  void end_stroke();
  void begin_step(const Command& first);
  void add_in_time(const Command& command);

  Outcome do_at_once(const Command& command, const Progress* progress);
  Outcome redo_at_once(size_t step, const Progress* progress);
  Result<StepResult> execute(size_t most, bool one_stage, const Progress* progress);
  void give_up(size_t step, bool stopped);
  Outcome finish(const Progress* progress);

  Outcome stop(const StopStroke& command, const Progress* progress);
  Outcome recut(const Recut& command);
  Outcome undo(const Progress* progress);
  Outcome redo(const Progress* progress);
  Outcome replay(size_t position, const Progress* progress);
  Status replay_steps(size_t position, const Progress* progress);
  Outcome finish_again(size_t step, const Progress& progress);
  Status undo_to(size_t position, size_t journal_size, UndoStack::Steps undone);
  HistoryStep& last() { return queue_.history().last(); }

  CommandQueue queue_;
  Origin origin_;
  CommandLog journal_;
  size_t revision_ = 0;
};

// A save point in the execution of the last history step of a document.
class Document::SavePoint {
 public:
  // Returns a save point of the current state; nullopt if no part of the step has been executed, a stroke
  // is being drawn, or before-images are not recorded. Splits the before-images of the step in two, so that
  // its undo needs more memory.
  static std::optional<SavePoint> create(Document& document);

  // Returns true if the document has changed since the save point only by execution of its queue.
  bool can_restore(const Document& document) const;
  // Restores the save point. The history and the journal are unchanged, and executing the queue again leads
  // to the same world, to the bit. Returns the changes. Costs as much as undoing that execution.
  // Precondition: can_restore(document).
  Delta restore(Document& document) const;
  // Keeps this save point valid after a later save point was restored.
  void follow(const Document& document) { revision_ = document.revision(); }

 private:
  SavePoint(const Document& document, CommandQueue::SavePoint reached)
      : revision_(document.revision()),
        position_(document.history().position()),
        reached_(std::move(reached)) {}

  size_t revision_, position_;
  CommandQueue::SavePoint reached_;
};

// Returns true if the last history step before the position is a stroke that Recut can cut again.
bool can_recut(const Document& document);

// Returns true if the last history step before the position is a stroke or a recut, and the before-images
// that lead to its start are kept.
bool can_restart_stroke(const Document& document);

struct QueueRun {
  size_t moves_a_step = 64;  // passed to Document::step
  size_t leave = 0;          // execution ends when the queue has at most this length
  // Called after each step with its result, also on failure. If it returns an error, execution ends with this
  // error. If it is empty, execution ends at the first step that fails.
  std::function<Status(const Result<StepResult>&)> told;
  const Progress* progress = nullptr;  // may stop execution before and within each step
};

// Executes the queue of a document step by step. Fails with the error that QueueRun::told returns, or with
// cancelled() if QueueRun::progress stops execution; the document undoes a stroke that is stopped within a
// step.
Status run_queue(Document& document, const QueueRun& how);

// Stops the beam: the stroke being executed ends at its current place, and the strokes queued behind it are
// undone; they can be redone. A stroke of which no part was executed is undone too. No-op if no moves are
// queued.
Outcome stop_strokes(Document& document);

}  // namespace kerf
