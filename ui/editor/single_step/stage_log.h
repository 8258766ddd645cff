#pragma once

#include <memory>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "core/document/single_step.h"
#include "core/tree/touched_walk.h"
#include "ui/render/bodies/overlay_marks.h"

namespace kerf {

// What is drawn of a stage that was just executed: the volumes that the beam sweeps, the faces that it
// touches, the faces that were made and those that were removed. Linear in these faces.
StageMarks mark_stage(const World& world, const StageRecord& stage);

// The last query of the tree in single steps, visited box by box.
class QueryWalk {
 public:
  // Traces the query of a stage that found faces, right after the stage. A beam of several rays asks the tree
  // once for each; these walks follow each other. Takes a constant factor more time than the query.
  void trace(const World& world, const StageRecord& found);
  void clear();

  // Whether the boxes are drawn; clear() leaves it as it is.
  bool drawn = false;

  bool empty() const { return visits_.empty(); }
  size_t size() const { return visits_.size(); }
  // The number of boxes that the display has visited: all, until it is set by visit(), to one at least.
  size_t visited() const { return visited_; }
  void visit(size_t boxes);

  // What became of the box that was visited last, and why: one sentence. Precondition: visited() > 0.
  std::string words() const;
  // How many of the boxes that were visited had this outcome.
  size_t count(TouchedWalk::Outcome outcome) const;
  // The face of the box that was visited last, if it is that of one face.
  FaceId face() const { return visited_ > 0 ? visits_[visited_ - 1].face : FaceId(); }

  // Adds the boxes that were visited to the marks. Of more than kMaxDrawn the latest are drawn.
  static constexpr size_t kMaxDrawn = 2000;
  void mark(StageMarks& marks) const;

 private:
  std::vector<TouchedWalk::Visit> visits_;
  BodyId body_;
  size_t visited_ = 0;
};

// The stages of the last stroke that were executed in single steps, and what is drawn of them.
class StageLog {
 public:
  // The number of stages that were executed.
  size_t done() const { return done_; }
  // The moves of the stroke that they belong to, and which stage of the last of them it was; 0 before the
  // first.
  size_t moves() const;
  size_t stage_of_move() const;
  // What the stages did, one sentence each: first those that were executed, then those that were executed
  // before the user went back.
  const std::vector<std::string>& told() const { return told_; }
  // The stage that was executed last; null if none was.
  const StageRecord* last() const { return last_ ? &*last_ : nullptr; }

  // Notes a stage right after it was executed. Lengths are told in the unit in which the work is shown.
  void note(const World& world, const StageRecord& stage, FileUnit unit);
  // The stroke was taken back to where so many stages were executed, to be executed again from there.
  // Precondition: no more than done().
  void restart(size_t stages = 0);
  // Another stroke, or another document.
  void forget();
  // A number that increases with every forget().
  size_t forgotten() const { return forgotten_; }

  // The last query of the tree, and how much of it is displayed.
  const QueryWalk& query() const { return query_; }
  void draw_query(bool drawn);
  void visit(size_t boxes);

  // What is drawn of the last stage and of the query; null if nothing is. `world` is the one right after the
  // stage. Made when it is first asked for after a change.
  std::shared_ptr<const StageMarks> marks(const World& world);

 private:
  size_t done_ = 0, forgotten_ = 0;
  std::vector<std::string> told_;
  std::vector<size_t> sweeps_;  // the numbers of the stages among them that begin a move, from 1 on
  std::optional<StageRecord> last_;
  size_t swept_ = 0;       // stages up to the last sweep
  std::set<PieceId> cut_;  // pieces that lost faces since then
  QueryWalk query_;
  std::shared_ptr<const StageMarks> marks_;
};

}  // namespace kerf
