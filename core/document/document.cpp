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
  moves_.clear();
  std::get<BeginStroke>(journal_[stroke_at_]).settings = settings;
  for (size_t i = stroke_at_; i < journal_.size(); ++i) run(journal_[i]);
}

void Document::run(const Command& command) {
  std::visit(Overloaded{
                 [&](const BeginStroke& begin) {
                   settings_ = begin.settings;
                   last_ = begin.pose;
                   in_stroke_ = true;
                   moves_.push_back({last_, last_});
                 },
                 [&](const MoveStroke& move) {
                   if (!in_stroke_) return;
                   for (const BeamMove& m : walk(last_, move.pose, settings_.laser.radius, reach(last_))) {
                     moves_.push_back(m);
                   }
                   last_ = move.pose;
                 },
                 [&](const EndStroke&) { in_stroke_ = false; },
             },
             command);
}

// How far along the beam there is anything to cut: to the farthest corner of the world's bounds.
double Document::reach(const Pose& pose) const {
  const World::Bounds bounds = world_.bounds();
  const Vec3 far = glm::max(glm::abs(bounds.min - pose.origin), glm::abs(bounds.max - pose.origin));
  return std::min(settings_.laser.range.high, glm::length(far));
}

Result<StepResult> Document::step(size_t moves, const Progress* progress) {
  const size_t count = std::min(moves, moves_.size());
  const std::vector<BeamMove> now(moves_.begin(), moves_.begin() + static_cast<std::ptrdiff_t>(count));
  moves_.erase(moves_.begin(), moves_.begin() + static_cast<std::ptrdiff_t>(count));
  Result<StepResult> result = cut_step(world_, settings_, now, progress);
  if (!result) {
    moves_.clear();
    in_stroke_ = false;
  }
  return result;
}

}  // namespace kerf
