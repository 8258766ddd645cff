#include "core/document/document.h"

#include <algorithm>
#include <utility>

#include "core/graph/separation.h"

namespace kerf {

namespace {

template <typename... Handlers>
struct Overloaded : Handlers... {
  using Handlers::operator()...;
};
template <typename... Handlers>
Overloaded(Handlers...) -> Overloaded<Handlers...>;

}  // namespace

void Document::apply(const Command& command) {
  if (std::holds_alternative<BeginStroke>(command)) {
    stroke_at_ = journal_.size();
    before_stroke_.reset();
    if (world_.live_faces() <= kMostFacesToRecut) before_stroke_ = world_;
    ++strokes_;
  }
  journal_.push_back(command);
  run(command);
}

void Document::recut(const CutSettings& settings) {
  if (!can_recut()) return;
  world_ = *before_stroke_;
  work_.clear();
  in_stroke_ = false;
  std::get<BeginStroke>(journal_[stroke_at_]).settings = settings;
  for (size_t i = stroke_at_; i < journal_.size(); ++i) run(journal_[i]);
}

void Document::run(const Command& command) {
  std::visit(Overloaded{
                 [&](const BeginStroke& c) { begin(c); },
                 [&](const MoveStroke& c) { move_to(c.pose); },
                 [&](const EndStroke&) { end(); },
                 [&](const auto&) {},
             },
             command);
}

void Document::begin(const BeginStroke& begin) {
  end();
  stroke_ = std::make_shared<Stroke>();
  stroke_->settings = begin.settings;
  last_ = begin.pose;
  in_stroke_ = true;
  stroke_->path.push_back({last_, last_});
  work_.push_back({{last_, last_}, false, stroke_});
}

void Document::move_to(const Pose& pose) {
  if (!in_stroke_) return;
  const auto moves = walk(last_, pose, stroke_->settings.laser.radius, reach(last_));
  for (const BeamMove& m : moves) work_.push_back({m, false, stroke_});
  if (pose.direction == last_.direction) {
    stroke_->path.push_back({last_, pose});
  } else {
    stroke_->path.insert(stroke_->path.end(), moves.begin(), moves.end());
  }
  last_ = pose;
}

void Document::end() {
  if (in_stroke_ && stroke_->settings.smooth()) work_.push_back({{last_, last_}, true, stroke_});
  in_stroke_ = false;
}

// How far along the beam there is anything to cut: to the farthest corner of the world's bounds.
double Document::reach(const Pose& pose) const {
  const World::Bounds bounds = world_.bounds();
  const Vec3 far = glm::max(glm::abs(bounds.min - pose.origin), glm::abs(bounds.max - pose.origin));
  return std::min(stroke_->settings.laser.range.high, glm::length(far));
}

Result<StepResult> Document::step(size_t moves, const Progress* progress) {
  if (work_.empty()) return go_on_separating(world_, stroke_->settings.search_a_step);
  StepResult all;
  const size_t stop = work_.size() - std::min(moves, work_.size());
  while (work_.size() > stop) {
    Result<StepResult> some = walk_some(work_.size() - stop, progress);
    if (!some) {
      work_.clear();
      in_stroke_ = false;
      return some.error();
    }
    all.delta.append(std::move(some->delta));
    all.figures.add(some->figures);
  }
  return all;
}

// The moves of one stroke that come next, or its end. What came apart in the stroke before is settled first,
// so that nothing of it is left to be found when a stroke begins.
Result<StepResult> Document::walk_some(size_t most, const Progress* progress) {
  const std::shared_ptr<Stroke> stroke = work_.front().stroke;
  if (!std::exchange(stroke->walked, true) && !is_settled(world_)) return go_on_separating(world_, kNoLimit);
  if (work_.front().closes) {
    work_.pop_front();
    return close_rim(world_, stroke->settings, stroke->path, progress);
  }
  std::vector<BeamMove> now;
  while (now.size() < most && !work_.empty() && !work_.front().closes && work_.front().stroke == stroke) {
    now.push_back(work_.front().move);
    work_.pop_front();
  }
  return cut_step(world_, stroke->settings, now, progress);
}

}  // namespace kerf
