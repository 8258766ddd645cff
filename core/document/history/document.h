#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "core/base/result.h"
#include "core/document/history/beam_queue.h"
#include "core/document/history/command_log.h"
#include "core/document/history/history.h"
#include "core/document/history/outcome.h"
#include "core/document/history/recorder.h"
#include "core/physics/physics.h"
#include "core/world/body_state.h"
#include "core/world/world.h"

namespace kerf {

// A world and the commands that led to it.
//
// The commands of a stroke, and Advance, only append moves of the beam and ticks of time to a queue, of which
// step() executes a bounded part. The result depends neither on the division into steps nor on when the queue
// runs empty: the same faces are removed, and the same pieces are separated, with the same labels. All other
// commands are executed at once, after everything in the queue.
//
// Time passes only by Advance commands. A tick starts when the moves before it have been executed and the
// search for separated pieces is finished. Bodies move in the ticks of Advance commands that say so: pieces
// that came off become bodies first (see release_pieces), and what touched a body that was changed wakes (see
// forget_contacts). In the history, time belongs to the stroke before it: it is undone with the stroke, and
// passes again when the stroke is cut again. After an edit it is a step of its own unless it says that it
// joins the edit (see Advance), and so are time with nothing before it and what Play begins.
//
// Undo and redo exchange before-images of what each step of the history changed. They are exact to the bit,
// and their cost is proportional to the change. If the before-images of a step were discarded to save memory,
// the document is replayed from its origin.
class Document {
 public:
  // Creates the world that the document started with again.
  using Origin = std::function<Result<World>(const Progress*)>;

  Document() = default;
  explicit Document(World world, Origin origin = {}) : world_(std::move(world)), origin_(std::move(origin)) {}

  const World& world() const { return world_; }

  // Applies the command and appends it to the journal. Every command except those of a stroke, Advance,
  // Pull and LetGo ends a running stroke. A move without a running stroke, and a command that has no effect,
  // are ignored and not written to the journal.
  //
  // A command that is executed at once first executes the whole queue. The outcome lists all changes of both.
  // If the command fails, it has changed nothing itself, but the queue has been executed, and the outcome
  // lists these changes.
  Outcome apply(const Command& command, const Progress* progress = nullptr);
  // Applies the commands of strokes and Advance commands and executes them to the end, all or nothing. On
  // failure, also if `progress` stopped it, the world, the journal and the history with its undone steps are
  // as before. The queue is executed first, which `progress` does not stop. The outcome lists all changes.
  Outcome run_whole(std::span<const Command> commands, const Progress* progress = nullptr);
  // Commands that only append to the queue.
  void apply(const BeginStroke& command);
  void apply(const MoveStroke& command);
  void apply(const EndStroke& command);
  void apply(const Advance& command);
  void apply(const Pull& command);
  void apply(const LetGo& command);
  // Begins a step of the history, and ends a running stroke.
  void apply(const Play& command);

  // The length of the queue: moves (including one that is partly executed), ticks, changes of the spring, and
  // ends of strokes with a smooth rim (see BeamQueue::size). At least 1 while no stroke is running and a
  // search for separated pieces is not finished.
  size_t waiting() const;
  // Whether the queue holds moves or ends of strokes, not only ticks and searches.
  bool beam_waits() const { return queue_.holds_beam(); }
  // Whether the queue holds moves.
  bool moves_wait() const { return queue_.holds_moves(); }
  // Whether the queue holds only ticks in which bodies stand still, so that nothing changes but heat.
  bool only_cools() const { return queue_.only_cools() && !must_separate(); }
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
  // The number of faces that the next step makes ready to move: those of bodies that pieces came off, and of
  // bodies that have changed since bodies moved last. Its cost is proportional to them. 0 if bodies do not
  // move in it.
  size_t next_makes_ready() const;

  // Executes a bounded part of the queue, which is one of these:
  // - up to `most` moves of one stroke, limited to CutSettings::bite faces, so that the last move may be left
  //   unfinished for the next step;
  // - a part of the end of a stroke with a smooth rim, limited in the same way;
  // - a part of the search for separated pieces, which must be finished before the next stroke or tick;
  // - up to `most` ticks, or one tick in which bodies move;
  // - a change of the spring.
  // Calling it while waiting() > 0 executes the whole queue.
  //
  // On failure the stroke is taken back, and whatever follows the world must read all of it again. If
  // `progress` stopped the step, the stroke is also undone in the journal, together with the queue behind it.
  // If no before-images are recorded (see set_window), the stroke ends where it was stopped instead.
  Result<StepResult> step(size_t most, const Progress* progress = nullptr);

  // The same, but executes only the next stage of a move through one body (see cut_stage), a part of the end
  // of a stroke or of the search, or one tick. The result of the stroke is the same.
  Result<StepResult> step_stage(const Progress* progress = nullptr);
  // How far the first move of the queue has been executed.
  const UnfinishedMove& unfinished_move() const { return queue_.unfinished(); }

  // Whether the next step executes work of the last step of the history, not of an earlier one.
  bool next_is_of_last_step() const;
  // Takes the last step of the history, a stroke or a recut, back, and appends its work to the queue again,
  // as if it had just been applied; a stroke may still be running. The history and the journal stay as they
  // are, and executing the queue again leads to the same world, to the bit. Returns what changed.
  // Precondition: can_start_again(), i.e. there is such a step and its before-images are kept.
  bool can_start_again() const;
  Delta start_again();

  // A place in the execution of the last step of the history.
  struct Mark {
    size_t revision = 0, position = 0;
    HistoryStep::Mark step;
    BeamQueue queue;
    std::shared_ptr<Stroke> stroke;
    size_t moves = 0;  // of its path
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

  // The settings and the commands so far of the last stroke that was not undone. Precondition: has_stroke().
  bool has_stroke() const { return history_.last_cut().has_value(); }
  const CutSettings& stroke_settings() const { return history_.settings_of(*history_.last_cut()); }
  const std::vector<Command>& last_stroke() const {
    return history_.step(history_.base_of(*history_.last_cut())).commands();
  }
  // A copy of the world as it was before that stroke. Nothing if its before-images were discarded, or if the
  // world has more faces than can be copied between two frames.
  static constexpr size_t kMostFacesToCopy = 400'000;
  std::optional<World> before_last_stroke();

  // The number of strokes that are not undone, including those in the queue and a running one.
  size_t strokes() const { return history_.strokes(); }
  bool in_stroke() const { return in_stroke_; }
  // The number of faces that these strokes removed so far, and their area (m^2).
  size_t removed_faces() const { return history_.removed_faces(); }
  double removed_area() const { return history_.removed_area(); }
  // A number that increases whenever a stroke is begun, stopped, cut again, undone or redone.
  size_t revision() const { return revision_; }

  // Puts bodies, as far as they exist, where a journal says that they came, and lets them move on as they did
  // there. It belongs to the last step of the history and is no command. Precondition: nothing waits, and
  // there is such a step.
  StepResult take_states(std::span<const BodyState> states, std::span<const NearPair> pairs);
  // The same where ticks and changes of the spring wait, which pass without bodies being moved.
  // Preconditions: nothing else waits, no beam is on, and the last step executed was a tick of the same step
  // of the history.
  StepResult skip_to(std::span<const BodyState> states, std::span<const NearPair> pairs);
  // So often details of contacts are forgotten (see forget_details), so that a state that a journal says of
  // a full minute is all that decides how bodies move on; they are also forgotten where a step begins.
  static constexpr Ticks kTicksToForget = 60 * kTicksPerSecond;

  // The steps that can be undone and redone.
  const History& history() const { return history_; }
  void set_window(size_t bytes) { history_.set_window(bytes); }
  // Whether the before-images that lead to a position are kept. Otherwise travel() has to replay.
  bool remembers_way_to(size_t position) const;
  // Goes to a position of the history by undo and redo. The outcome lists all changes, also on failure.
  Outcome travel(size_t position, const Progress* progress = nullptr);

  // The physics of the bodies, with the contacts and figures of the last tick in which they moved.
  const Physics& physics() const { return physics_; }

  // All commands that were applied, including Undo and Redo.
  const std::vector<Command>& journal() const { return journal_.commands(); }
  // The number of commands that do not change any more. The last one may be an Advance of less than a second,
  // to which further time is added.
  size_t final_commands() const { return journal_.final_size(); }
  // Makes all of them final, so that they can be written to a file.
  void seal_journal() { journal_.seal(); }

 private:
  // Appending to the queue.
  void begin_step(const Command& first);
  void add_in_time(const Command& command);
  void end_stroke();
  void queue_commands(size_t step);
  void queue_time_of_edit(size_t at);
  void queue_command(size_t step, const Command& command);

  // Executing the front of the queue.
  bool must_separate() const;
  StepResult separate_more();
  Result<StepResult> step_front(size_t most, bool one_stage, const Progress* progress);
  Result<StepResult> walk_moves(size_t most, const Progress& progress);
  Result<StepResult> walk_stage(const Progress& progress);
  Result<StepResult> close_rim_of_stroke(const Progress& progress);
  Result<StepResult> pass_ticks(size_t most, const Progress& progress);
  Result<StepResult> move_bodies(size_t step, const Progress& progress);
  Result<StepResult> move_under_beam(size_t step, const Progress& progress);
  StepResult change_spring();
  void keep_open(size_t step);
  void begin(size_t step);
  // Ends the recording of the open step, if there is one. close() does not trim the history to its window,
  // because the images of a step that is about to be taken back must be kept.
  void close();
  void close_and_trim();
  void note(size_t step, const StepResult& some);
  void note_cut(size_t step, const StepResult& some);
  StepResult noted(size_t step, StepResult some);
  bool is_over(size_t step) const;
  void finish_step(size_t step);
  void queue_in_front(size_t step, const Command& command);
  void give_up(size_t step, bool stopped);
  Outcome finish(const Progress* progress);

  // Commands that are executed at once.
  Result<Delta> run(HistoryStep& step, size_t at, const Progress* progress);
  Outcome do_at_once(const Command& command, const Progress* progress);
  Outcome redo_at_once(size_t step, const Progress* progress);

  // History.
  Outcome stop(const StopStroke& command, const Progress* progress);
  Outcome recut(const Recut& command);
  Delta cut_again();
  bool can_walk_again(size_t step) const;
  Delta walk_again();
  Outcome undo(const Progress* progress);
  Outcome pass_last_ticks();
  Outcome redo(const Progress* progress);
  Outcome replay(size_t position, const Progress* progress);
  Status take_back_to(size_t position, size_t journal_size, std::vector<std::unique_ptr<HistoryStep>> undone);
  Status replay_steps(size_t position, const Progress* progress);
  bool is_last(size_t step) const { return step + 1 == history_.position(); }

  World world_;
  Origin origin_;
  CommandLog journal_;
  History history_;
  BeamQueue queue_;
  Recorder recorder_;
  Physics physics_;
  std::shared_ptr<Stroke> drawn_;   // the last stroke that was appended to the queue
  std::shared_ptr<Stroke> walked_;  // the last stroke that was executed
  bool in_stroke_ = false;
  size_t revision_ = 0;
};

}  // namespace kerf
