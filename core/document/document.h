#pragma once

#include <deque>
#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include "core/base/result.h"
#include "core/document/command.h"
#include "core/document/history.h"
#include "core/document/stroke.h"
#include "core/world/world.h"

namespace kerf {

// A world and the commands that led to it.
//
// Commands say what happens; steps let it happen: a command of a stroke queues moves of the beam, and step()
// walks as many of them as it is asked to, or as a bite holds. However the moves are dealt out to steps, the
// same faces go and the same pieces come off. All other commands happen at once, after what waits.
//
// A history goes back and forth by before-images of what each stroke or other command changed, exact to the
// bit, at the cost of what was changed. Where those were let go it starts again from the origin.
class Document {
 public:
  // Makes the world that the document began with once more.
  using Origin = std::function<Result<World>(const Progress*)>;

  Document() = default;
  explicit Document(World world, Origin origin = {}) : world_(std::move(world)), origin_(std::move(origin)) {}

  const World& world() const { return world_; }

  // Does the command, or queues its moves, and appends it to the journal. A stroke that is running is ended
  // by any command but those of a stroke; moves without a stroke, and commands for which there is nothing to
  // do, do nothing and are not written. What changed at once is in the delta. On failure nothing has changed.
  Result<Delta> apply(const Command& command, const Progress* progress = nullptr);
  // Those of a stroke only queue.
  void apply(const BeginStroke& command);
  void apply(const MoveStroke& command);
  void apply(const EndStroke& command);

  // Moves that wait, one that was left half-way among them; the end of a stroke with a smooth rim counts as
  // one, and so does a search for what came apart that is left when no move waits.
  size_t waiting() const;
  // The first of them; null when none waits.
  const BeamMove* next_move() const { return work_.empty() ? nullptr : &work_.front().move; }
  // Whether the next step ends a stroke with a smooth rim, which takes long after a long stroke.
  bool next_closes_rim() const { return !work_.empty() && work_.front().closes; }

  // One step of bounded work: walks up to so many of them, of one stroke, and no more than a bite
  // (CutSettings::bite), so that the last may be left half-way for the next step; ends a stroke with a smooth
  // rim, whatever it costs; or, when a stroke is walked, goes on with a search for what came apart in it.
  // Called while anything waits, it does all. On failure the stroke has cut nothing; where `progress` stopped
  // it, it is taken back in the journal too, with what waits behind it. Without before-images it ends where
  // it is.
  Result<StepResult> step(size_t moves, const Progress* progress = nullptr);

  // What a Recut may take back.
  bool can_recut() const;

  // Of the last stroke that is not taken back: how it cuts and its commands as far as they came. There is
  // one.
  bool has_stroke() const { return last_cut().has_value(); }
  const CutSettings& stroke_settings() const;
  const std::vector<Command>& last_stroke() const;
  // A copy of the world as it was before it; none where that is not remembered, and where it is too large to
  // be copied between two frames.
  static constexpr size_t kMostFacesToCopy = 400'000;
  std::optional<World> before_last_stroke();

  // Strokes that are in the world or wait, the last of them perhaps running.
  size_t strokes() const;
  bool in_stroke() const { return in_stroke_; }
  // How many faces all of them removed, and how much area (m^2, see Delta::removed_area).
  size_t removed_faces() const;
  double removed_area() const;
  // A number that grows whenever a stroke is begun, cut again, taken back or brought again.
  size_t revision() const { return revision_; }

  // The steps that can be taken back and forth.
  const History& history() const { return history_; }
  void set_window(size_t bytes) { history_.set_window(bytes); }
  // Whether the way back to a position is remembered; otherwise going there takes a replay.
  bool remembers_way_to(size_t position) const;
  // Goes to a position of the history by Undo and Redo.
  Result<Delta> travel(size_t position, const Progress* progress = nullptr);

  // All commands that were applied, Undo and Redo too.
  const std::vector<Command>& journal() const { return journal_; }

 private:
  // A move of the beam, or the end of a stroke with a smooth rim, of a step of the history.
  struct Work {
    size_t step;
    BeamMove move;
    bool closes = false;
    std::shared_ptr<Stroke> stroke;
  };

  void end();
  void run(size_t step, const Command& command, const CutSettings* instead = nullptr);
  void queue(size_t step);
  Delta walk_again();

  Result<Delta> recut(const Recut& command);
  Delta cut_again();
  Result<Delta> undo(const Progress* progress);
  Result<Delta> redo(const Progress* progress);
  Result<Delta> at_once(const Command& command, const Progress* progress);
  Result<Delta> do_at_once(HistoryStep& step, Delta& walked, const Progress* progress);
  Result<Delta> redo_at_once(size_t step, const Progress* progress);
  Result<Delta> replay(size_t position, const Progress* progress);
  Status finish(Delta& walked, const Progress* progress);

  Result<StepResult> walk_some(size_t most, const Progress& progress);
  StepResult noted(size_t step, StepResult some);
  void give_up(size_t step, bool stopped);
  void remember(size_t step);
  void close();
  void settle(size_t step);
  bool waits(size_t step) const;
  void drop_work(size_t step);
  double reach(const Pose& pose) const;
  bool cuts(size_t step) const;
  size_t base_of(size_t step) const;
  bool is_cut_again(size_t step) const;
  bool can_go_before(size_t last) const;
  std::optional<size_t> last_cut() const;

  World world_;
  Origin origin_;
  std::vector<Command> journal_;
  History history_;
  std::deque<Work> work_;
  UnfinishedMove unfinished_;       // the first of work_, where it was left
  std::shared_ptr<Stroke> stroke_;  // the one that is drawn, or queued again
  std::optional<size_t> open_;      // the step that is walked
  bool remembering_ = false;        // and whether what it changes is saved
  bool in_stroke_ = false;
  size_t revision_ = 0;
};

}  // namespace kerf
