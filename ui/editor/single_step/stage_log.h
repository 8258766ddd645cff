#pragma once

#include <memory>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "core/document/single_step.h"
#include "core/tree/queries.h"
#include "ui/render/bodies/overlay_marks.h"

namespace kerf {

// Returns the overlay of a stage right after its execution: swept volumes, hit faces, created and removed
// faces. Linear in these faces.
StageMarks mark_stage(const World& world, const StageRecord& stage);

// The last tree query in single steps, visited box by box.
class QueryWalk {
 public:
  // Traces the query of a stage that searched faces, right after the stage. A beam of several rays queries
  // the tree once per ray; the walks are appended. Costs a constant factor more than the query.
  void trace(const World& world, const StageRecord& found);
  void clear();

  // Draws the boxes; not changed by clear().
  bool drawn = false;

  bool empty() const { return visits_.empty(); }
  size_t size() const { return visits_.size(); }
  // Number of boxes shown as visited: all, or as set by visit(), which limits it to at least one.
  size_t visited() const { return visited_; }
  void visit(size_t boxes);

  // Returns the outcome of the last visited box, and the reason, as a sentence. Precondition: visited() > 0.
  std::string words() const;
  // Returns the number of visited boxes with this outcome.
  size_t count(TouchedWalk::Outcome outcome) const;
  // Returns the face of the last visited box if it is a leaf, else an invalid id.
  FaceId face() const { return visited_ > 0 ? visits_[visited_ - 1].face : FaceId(); }

  // Adds the visited boxes to the overlay, at most the last kMaxDrawn.
  static constexpr size_t kMaxDrawn = 2000;
  void mark(StageMarks& marks) const;

 private:
  std::vector<TouchedWalk::Visit> visits_;
  BodyId body_;
  size_t visited_ = 0;
};

// The executed stages of the last stroke, and their overlay.
class StageLog {
 public:
  size_t done() const { return done_; }
  // Number of segments of the stroke begun so far, and the number of the last stage within its segment; 0
  // before the first.
  size_t moves() const;
  size_t stage_of_move() const;
  // One sentence per stage: the executed ones, then those executed before going back.
  const std::vector<std::string>& told() const { return told_; }
  // The last executed stage, or null.
  const StageRecord* last() const { return last_ ? &*last_ : nullptr; }

  // Records a stage right after its execution. Lengths in its sentence are in `unit`.
  void note(const World& world, const StageRecord& stage, FileUnit unit);
  // Records that the stroke was undone to its first `stages` stages. Precondition: stages <= done().
  void restart(size_t stages = 0);
  void forget();
  // Number of calls of forget().
  size_t forgotten() const { return forgotten_; }

  const QueryWalk& query() const { return query_; }
  void draw_query(bool drawn);
  void visit(size_t boxes);

  // Returns the overlay of the last stage and of the query, or null if it is empty. `world`: right after the
  // stage. Computed on the first call after a change.
  std::shared_ptr<const StageMarks> marks(const World& world);

 private:
  size_t done_ = 0, forgotten_ = 0;
  std::vector<std::string> told_;
  std::vector<size_t> sweeps_;  // numbers (from 1) of the stages that begin a segment
  std::optional<StageRecord> last_;
  size_t swept_ = 0;       // stages up to the last sweep
  std::set<PieceId> cut_;  // pieces that lost faces since then
  QueryWalk query_;
  std::shared_ptr<const StageMarks> marks_;
};

}  // namespace kerf
