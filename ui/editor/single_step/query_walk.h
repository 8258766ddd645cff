#pragma once

#include <string>
#include <vector>

#include "core/document/history/single_step.h"
#include "core/tree/touched_walk.h"
#include "ui/render/bodies/stage_marks.h"

namespace kerf {

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

  // Adds the boxes that were visited to the marks. Of more than kMostDrawn the latest are drawn.
  static constexpr size_t kMostDrawn = 2000;
  void mark(StageMarks& marks) const;

 private:
  std::vector<TouchedWalk::Visit> visits_;
  BodyId body_;
  size_t visited_ = 0;
};

}  // namespace kerf
