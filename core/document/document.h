#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include "core/base/result.h"
#include "core/document/beam_queue.h"
#include "core/document/command_log.h"
#include "core/document/history.h"
#include "core/document/outcome.h"
#include "core/document/recorder.h"
#include "core/world/world.h"

namespace kerf {

// A world and the commands that led to it.
//
// A command of a stroke, and one that lets time pass, queues what it asks for; step() does it, as much at a
// time as it is asked for or as a bite holds. However that is dealt out to steps, the same faces go and the
// same pieces come off. All other commands happen at once, after what waits.
//
// Time passes where the commands say so (see Advance): a tick begins when the moves before it are walked and
// what came apart in them is known. In the history it belongs to the stroke before it, is undone with it, and
// passes again when the stroke is cut again; where there is no stroke before it, it is a step of its own.
//
// Undo and redo exchange before-images of what each step of the history changed, exact to the bit, at the
// cost of what was changed. Where those were let go the document starts again from its origin.
class Document {
 public:
  // Makes the world that the document began with once more.
  using Origin = std::function<Result<World>(const Progress*)>;

  Document() = default;
  explicit Document(World world, Origin origin = {}) : world_(std::move(world)), origin_(std::move(origin)) {}

  const World& world() const { return world_; }

  // Applies the command and appends it to the journal. Commands but those of a stroke and Advance end a
  // stroke that is running. Moves without a stroke, and commands for which there is nothing to do, do nothing
  // and are not written.
  //
  // A command that happens at once has all that waits walked first. The outcome tells all that changed, also
  // where it failed; the command itself has then done nothing, but what waited before it is done.
  Outcome apply(const Command& command, const Progress* progress = nullptr);
  // These only queue.
  void apply(const BeginStroke& command);
  void apply(const MoveStroke& command);
  void apply(const EndStroke& command);
  void apply(const Advance& command);

  // How many moves wait, one that was left half-way among them, with ticks and ends of strokes with a smooth
  // rim (see BeamQueue::size); at least 1 while a search for what came apart is not finished.
  size_t waiting() const;
  // Whether moves or ends of strokes wait, not only ticks and searches.
  bool beam_waits() const { return queue_.holds_beam(); }
  // The move that the next step walks first; none where it walks none.
  std::optional<BeamMove> next_move() const { return queue_.next_move(world_); }
  // Whether the next step ends a stroke with a smooth rim, which takes long after a long stroke.
  bool next_closes_rim() const;

  // One step of bounded work: walks up to `most` moves of one stroke, but no more than a bite
  // (CutSettings::bite), so that the last of them may be left half-way for the next step; or ends a stroke
  // with a smooth rim, whatever that costs; or goes on with a search for what came apart, before the next
  // stroke or tick begins; or lets up to `most` ticks pass. Called while anything waits, it does all.
  //
  // On failure the stroke has cut nothing, and who follows the world must look at all of it again; where
  // `progress` stopped it, it is undone in the journal too, with what waits behind it. Where no before-images
  // are made, the stroke ends where it is.
  Result<StepResult> step(size_t most, const Progress* progress = nullptr);

  // Whether the step before the position is a stroke, cut again or not, that a Recut can take back.
  bool can_recut() const;

  // The settings and the commands so far of the last stroke that was not undone. Precondition: has_stroke().
  bool has_stroke() const { return history_.last_cut().has_value(); }
  const CutSettings& stroke_settings() const { return history_.settings_of(*history_.last_cut()); }
  const std::vector<Command>& last_stroke() const {
    return history_.step(history_.base_of(*history_.last_cut())).commands();
  }
  // A copy of the world as it was before that stroke; none where that is not remembered, and where the world
  // is too large to be copied between two frames.
  static constexpr size_t kMostFacesToCopy = 400'000;
  std::optional<World> before_last_stroke();

  // Strokes that are in the world or wait, the last of them perhaps running.
  size_t strokes() const { return history_.strokes(); }
  bool in_stroke() const { return in_stroke_; }
  // Faces that all of them removed, and their area (m^2).
  size_t removed_faces() const { return history_.removed_faces(); }
  double removed_area() const { return history_.removed_area(); }
  // A number that grows whenever a stroke is begun, cut again, undone or redone.
  size_t revision() const { return revision_; }

  // The steps that can be undone and redone.
  const History& history() const { return history_; }
  void set_window(size_t bytes) { history_.set_window(bytes); }
  // Whether the way back to a position is remembered; otherwise going there takes a replay.
  bool remembers_way_to(size_t position) const;
  // Goes to a position of the history by undo and redo. The outcome tells all that changed, also on failure.
  Outcome travel(size_t position, const Progress* progress = nullptr);

  // All commands that were applied, Undo and Redo too.
  const std::vector<Command>& journal() const { return journal_.commands(); }
  // How many of them are final: the last may be an Advance that grows to a whole second.
  size_t final_commands() const { return journal_.final_size(); }
  // Makes all of them final, so that who writes the journal down need not come back to them.
  void seal_journal() { journal_.seal(); }

 private:
  // Drawing.
  void end_stroke();
  void queue_commands(size_t step);
  void queue_command(size_t step, const Command& command);

  // Walking: of what comes first in the queue.
  bool must_separate() const;
  StepResult separate_more();
  Result<StepResult> walk_moves(size_t most, const Progress& progress);
  Result<StepResult> close_rim_of_stroke(const Progress& progress);
  StepResult pass_ticks(size_t most);
  void begin(size_t step);
  // Ends the recording of the step that is open, if one is. The images of a step that is about to be taken
  // back must not be let go, so close() does not look at the window.
  void close();
  void close_and_trim();
  StepResult noted(size_t step, StepResult some);
  bool is_over(size_t step) const;
  void finish_step(size_t step);
  void give_up(size_t step, bool stopped);
  Outcome finish(const Progress* progress);

  // Commands that happen at once.
  Result<Delta> run(HistoryStep& step, size_t at, const Progress* progress);
  Outcome do_at_once(const Command& command, const Progress* progress);
  Outcome redo_at_once(size_t step, const Progress* progress);

  // History.
  Outcome recut(const Recut& command);
  Delta cut_again();
  bool can_walk_again(size_t step) const;
  Delta walk_again();
  Outcome undo(const Progress* progress);
  Outcome redo(const Progress* progress);
  Outcome replay(size_t position, const Progress* progress);
  Status replay_steps(size_t position, const Progress* progress);
  bool is_last(size_t step) const { return step + 1 == history_.position(); }

  World world_;
  Origin origin_;
  CommandLog journal_;
  History history_;
  BeamQueue queue_;
  Recorder recorder_;
  std::shared_ptr<Stroke> drawn_;   // the stroke that was queued last
  std::shared_ptr<Stroke> walked_;  // the stroke that was walked last
  bool in_stroke_ = false;
  size_t revision_ = 0;
};

}  // namespace kerf
