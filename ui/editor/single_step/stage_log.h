#pragma once

#include <memory>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "ui/editor/single_step/query_walk.h"

namespace kerf {

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
