#include "core/document/document.h"

#include <algorithm>

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
  if (const auto* again = std::get_if<Recut>(&command)) return recut(again->settings);
  if (std::holds_alternative<BeginStroke>(command)) {
    stroke_at_ = journal_.size();
    stroke_commands_ = 0;
    before_stroke_.reset();
    if (world_.live_faces() <= kMostFacesToRecut) before_stroke_ = world_;
    ++strokes_;
  }
  journal_.push_back(command);
  ++stroke_commands_;
  run(command);
}

void Document::recut(const CutSettings& settings) {
  if (!can_recut()) return;
  world_ = *before_stroke_;
  work_.clear();
  in_stroke_ = false;
  for (const Command& command : last_stroke()) {
    const auto* start = std::get_if<BeginStroke>(&command);
    run(start != nullptr ? Command(BeginStroke{settings, start->pose}) : command);
  }
  journal_.push_back(Recut{settings});
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

// How far along the beam there is anything to cut: to the farthest corner of the bounds of the world as it
// was before anything was cut. How small it is by now depends on how far the cut has come, and the moves must
// not.
double Document::reach(const Pose& pose) const {
  const Vec3 far = glm::max(glm::abs(bounds_.min - pose.origin), glm::abs(bounds_.max - pose.origin));
  return std::min(stroke_->settings.laser.range.high, glm::length(far));
}

Result<StepResult> Document::step(size_t moves, const Progress* progress) {
  StepResult all;
  const size_t stop = work_.size() - std::min(moves, work_.size());
  while (work_.size() > stop) {
    const std::shared_ptr<Stroke> stroke = work_.front().stroke;
    Result<StepResult> one = walk_one(progress);
    if (!one) {
      drop(stroke);
      return one.error();
    }
    all.delta.append(std::move(one->delta));
    all.figures.add(one->figures);
  }
  return all;
}

void Document::drop(const std::shared_ptr<Stroke>& stroke) {
  std::erase_if(work_, [&](const Work& work) { return work.stroke == stroke; });
  if (stroke_ == stroke) in_stroke_ = false;
}

// The move that comes next, or the end of a stroke. One at a time, so that pieces come apart, and get their
// labels, in the same order however the moves are dealt out to steps.
Result<StepResult> Document::walk_one(const Progress* progress) {
  const Work work = std::move(work_.front());
  work_.pop_front();
  if (work.closes) return close_rim(world_, work.stroke->settings, work.stroke->path, progress);
  return cut_step(world_, work.stroke->settings, std::span(&work.move, 1), progress);
}

}  // namespace kerf
