#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "core/base/assert.h"
#include "core/base/result.h"
#include "core/document/command_log.h"
#include "core/document/execution.h"
#include "core/world/rigid_body.h"
#include "core/world/world.h"

namespace kerf {

// The result of a command: what changed in the world, and the error if the command failed. The delta may be
// non-empty also on failure, because the queue of the document is executed before the command.
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

  // Makes this the outcome of this command and the next one together. Precondition: ok().
  void append(Outcome later) {
    KERF_ASSERT(ok());
    delta.append(std::move(later.delta));
    error_ = std::move(later.error_);
  }

 private:
  std::optional<Error> error_;
};

// A world and the commands that led to it.
//
// The commands of a stroke, and AdvanceTime, only append moves of the beam and ticks of time to a queue, of
// which step() executes a bounded part (see Execution). All other commands are executed at once, after
// everything in the queue.
//
// Time passes only by AdvanceTime commands. In the history, time belongs to the stroke before it: it is
// undone with the stroke, and passes again when the stroke is cut again. After an edit it is a step of its
// own unless it says that it joins the edit (see AdvanceTime), and so are time with nothing before it and
// what Play begins.
//
// Undo and redo exchange before-images of what each step of the history changed. They are exact to the bit,
// and their cost is proportional to the change. If the before-images of a step were discarded to save memory,
// the document is replayed from its origin.
class Document {
 public:
  // Creates the world that the document started with again.
  using Origin = std::function<Result<World>(const Progress*)>;

  Document() = default;
  explicit Document(World world, Origin origin = {})
      : execution_(std::move(world)), origin_(std::move(origin)) {}

  const World& world() const { return execution_.world(); }
  // The queue of commands that wait, and how far it has been executed.
  const Execution& execution() const { return execution_; }
  // The steps that can be undone and redone.
  const History& history() const { return execution_.history(); }
  // The limit for their before-images (see History::set_window).
  void set_window(size_t bytes) { execution_.history().set_window(bytes); }

  // The number of face slots, i.e. of faces that live or were removed, that the memory of this machine is
  // enough for (see usual_face_budget); by itself there is no limit. A stroke that makes more fails like one
  // that `progress` stopped: it is undone, in the journal too, so that the limit does not decide what a
  // replay leads to.
  void set_face_budget(size_t slots) { execution_.set_face_budget(slots); }

  // Applies the command and appends it to the journal. Every command except those of a stroke, AdvanceTime,
  // DragBody and ReleaseBody ends a running stroke. A move without a running stroke, and a command that has
  // no effect, are ignored and not written to the journal.
  //
  // A command that is executed at once first executes the whole queue. The outcome lists all changes of both.
  // If the command fails, it has changed nothing itself, but the queue has been executed, and the outcome
  // lists these changes.
  Outcome apply(const Command& command, const Progress* progress = nullptr);
  // Applies the commands of strokes and AdvanceTime commands and executes them to the end, all or nothing. On
  // failure, also if `progress` stopped it, the world, the journal and the history with its undone steps are
  // as before. The queue is executed first, which `progress` does not stop. The outcome lists all changes.
  Outcome run_whole(std::span<const Command> commands, const Progress* progress = nullptr);

  // The length of the queue (see Execution::waiting).
  size_t waiting() const { return execution_.waiting(); }

  // Executes a bounded part of the queue, which is one of these:
  // - up to `most` moves of one stroke, limited to CutSettings::bite faces, so that the last move may be left
  //   unfinished for the next step;
  // - a part of the end of a stroke with a smooth rim, limited in the same way;
  // - a part of the search for separated pieces, which must be finished before the next stroke or tick;
  // - up to `most` ticks, or one tick in which bodies move;
  // - a change of the spring.
  // Calling it while waiting() > 0 executes the whole queue.
  //
  // On failure the stroke is taken back, and so is the one that it cuts again; whatever follows the world
  // must read all of it again. If `progress` stopped the step, the stroke is also undone in the journal,
  // together with the queue behind it. If no before-images are recorded (see set_window), the stroke ends
  // where it was stopped instead.
  Result<StepResult> step(size_t most, const Progress* progress = nullptr) {
    return execute(most, false, progress);
  }

  // Executes a part like step(), but only the next stage of a move through one body (see cut_stage), a part
  // of the end of a stroke or of the search, or one tick. The result of the stroke is the same.
  Result<StepResult> step_stage(const Progress* progress = nullptr) { return execute(1, true, progress); }

  // Takes the last step of the history, a stroke or a recut, back, and appends its work to the queue again,
  // as if it had just been applied; a stroke may still be running. The history and the journal stay as they
  // are, and executing the queue again leads to the same world, to the bit. Returns what changed.
  // Precondition: can_start_again(), i.e. there is such a step and its before-images are kept.
  bool can_start_again() const;
  Delta start_again();

  // A place in the execution of the last step of the history.
  struct Mark {
    size_t revision = 0, position = 0;
    Execution::Mark reached;
  };
  // The place that the execution has reached. Nothing if no part of the step has been executed, if a stroke
  // is being drawn, or if before-images are not recorded. Splits the before-images of the step in two, so
  // that its undo takes more memory.
  std::optional<Mark> mark();
  // Goes back to a place. The history and the journal stay as they are, and executing the queue again leads
  // to the same world, to the bit. Returns what changed. Precondition: can_go_back_to(mark), i.e. since then
  // the queue has only been executed. Costs as much as undoing what was executed since then.
  bool can_go_back_to(const Mark& mark) const;
  Delta go_back_to(const Mark& mark);

  // Whether the last step of the history before the position is a stroke that Recut can cut again.
  bool can_recut() const;

  // A copy of the world as it was before the last stroke that was not undone. Nothing if its before-images
  // were discarded, or if the world has more faces than can be copied between two frames.
  static constexpr size_t kMaxFacesToCopy = 400'000;
  std::optional<World> before_last_stroke();

  // A number that increases whenever a stroke is begun, stopped, cut again, undone or redone.
  size_t revision() const { return revision_; }

  // Puts bodies, as far as they exist, where a journal says that they came, and lets them move on as they did
  // there. It belongs to the last step of the history and is no command. Precondition: nothing waits, and
  // there is such a step.
  StepResult take_states(std::span<const BodyState> states, std::span<const NearPair> pairs) {
    return execution_.take_states(states, pairs);
  }
  // Puts bodies like take_states() where ticks and changes of the spring wait, which pass without bodies
  // being moved. Preconditions: nothing else waits, no beam is on, and the last step executed was a tick of
  // the same step of the history.
  StepResult skip_to(std::span<const BodyState> states, std::span<const NearPair> pairs) {
    return execution_.skip_to(states, pairs);
  }

  // Whether the before-images that lead to a position are kept. Otherwise travel() has to replay.
  bool remembers_way_to(size_t position) const;
  // Goes to a position of the history by undo and redo. The outcome lists all changes, also on failure.
  Outcome travel(size_t position, const Progress* progress = nullptr);

  // All commands that were applied, including Undo and Redo.
  const std::vector<Command>& journal() const { return journal_.commands(); }
  // The number of commands that do not change any more. The last one may be an AdvanceTime of less than a
  // second, to which further time is added.
  size_t final_commands() const { return journal_.final_size(); }
  // Makes all of them final, so that they can be written to a file.
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
  Status take_back_to(size_t position, size_t journal_size, std::vector<std::unique_ptr<HistoryStep>> undone);
  bool is_last(size_t step) const { return step + 1 == history().position(); }
  HistoryStep& last() { return execution_.history().last(); }

  Execution execution_;
  Origin origin_;
  CommandLog journal_;
  size_t revision_ = 0;
};

// How the queue of a document is executed.
struct QueueRun {
  size_t moves_a_step = 64;  // the limit that Document::step is given
  size_t leave = 0;          // execution ends when the queue is not longer than this
  // Called after each step with its result, also if the step failed. Execution ends with the error that it
  // returns, if any. Without this function, execution ends with the first step that fails.
  std::function<Status(const Result<StepResult>&)> told;
  const Progress* progress = nullptr;  // may stop execution before and within each step
};

// Executes the queue of a document step by step. Fails with the error of `told`, or with cancelled() if
// `progress` stopped it; a stroke that was stopped within a step is undone by the document.
Status run_queue(Document& document, const QueueRun& how);

// Stops what the beam is at: the stroke that is being executed ends where it is, and those that wait behind
// it are undone, so that they can be redone. Also undoes a stroke of which nothing was executed. Does nothing
// if no moves wait.
Outcome stop_strokes(Document& document);

}  // namespace kerf
