#include "ui/editor/single_step/stage_log.h"

#include <algorithm>

#include "core/base/assert.h"
#include "ui/editor/single_step/mark_stage.h"

namespace kerf {

// A stage that is executed again says the same; one of another queue does not.
void StageLog::note(const World& world, const StageRecord& stage, FileUnit unit) {
  std::string sentence = words(stage, unit);
  if (done_ < told_.size() && told_[done_] != sentence) told_.resize(done_);
  while (!sweeps_.empty() && sweeps_.back() > told_.size()) sweeps_.pop_back();
  if (done_ == told_.size()) told_.push_back(std::move(sentence));
  ++done_;
  const bool found = stage.kind == StageRecord::Kind::kHit || stage.kind == StageRecord::Kind::kHitAgain;
  if (found && world.contains(stage.body)) query_.trace(world, stage);
  if (stage.kind == StageRecord::Kind::kSweep) {
    swept_ = done_;
    if (sweeps_.empty() || sweeps_.back() < done_) sweeps_.push_back(done_);
    cut_.clear();
  }
  for (const BodyDelta& delta : stage.done.delta.bodies) {
    for (const CutFace& face : delta.removed) cut_.insert({delta.body, face.piece});
  }
  last_ = stage;
  marks_.reset();
}

size_t StageLog::moves() const {
  return static_cast<size_t>(std::upper_bound(sweeps_.begin(), sweeps_.end(), done_) - sweeps_.begin());
}

size_t StageLog::stage_of_move() const { return moves() == 0 ? done_ : done_ - sweeps_[moves() - 1] + 1; }

// The last query is that of the last sweep, or comes again with the stages that follow.
void StageLog::restart(size_t stages) {
  KERF_ASSERT(stages <= done_);
  done_ = stages;
  last_.reset();
  if (stages < swept_) query_.clear();
  marks_.reset();
}

void StageLog::forget() {
  restart();
  told_.clear();
  sweeps_.clear();
  ++forgotten_;
}

void StageLog::draw_query(bool drawn) {
  query_.drawn = drawn;
  marks_.reset();
}

void StageLog::visit(size_t boxes) {
  query_.visit(boxes);
  draw_query(true);
}

std::shared_ptr<const StageMarks> StageLog::marks(const World& world) {
  if (!last_) return nullptr;
  if (marks_) return marks_;
  StageMarks marks = mark_stage(world, *last_);
  if (!marks.came_off.empty()) {
    for (const PieceId& piece : cut_) {
      if (std::count(marks.came_off.begin(), marks.came_off.end(), piece) == 0) marks.stayed.push_back(piece);
    }
  }
  if (query_.drawn) query_.mark(marks);
  marks_ = std::make_shared<const StageMarks>(std::move(marks));
  return marks_;
}

}  // namespace kerf
