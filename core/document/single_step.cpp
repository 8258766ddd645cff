#include "core/document/single_step.h"

#include "core/base/assert.h"
#include "core/cut/cut_step.h"
#include "core/document/cut_effects.h"

namespace kerf {

namespace {

using StageKind = StageRecord::Kind;

StageKind kind_of(UnfinishedMove::Stage stage) {
  switch (stage) {
    case UnfinishedMove::Stage::kFind:
      return StageKind::kHit;
    case UnfinishedMove::Stage::kRefine:
      return StageKind::kRefine;
    case UnfinishedMove::Stage::kFindAgain:
      return StageKind::kHitAgain;
    case UnfinishedMove::Stage::kRemove:
      return StageKind::kRemove;
    case UnfinishedMove::Stage::kSeparate:
      return StageKind::kSeparate;
  }
  return StageKind::kHit;
}

size_t count_specks(const Delta& delta, const Document& document) {
  if (!document.history().last_cut()) return 0;
  return new_specks(document.world(), delta, document.history().last_settings().laser.radius).size();
}

// Joins in pairs, because appending one after the other would take quadratic time.
Delta joined(std::vector<Delta> changes) {
  KERF_ASSERT(!changes.empty());
  for (size_t width = 1; width < changes.size(); width *= 2) {
    for (size_t i = 0; i + width < changes.size(); i += 2 * width)
      changes[i].append(std::move(changes[i + width]));
  }
  return std::move(changes.front());
}

}  // namespace

StageRecord SingleStep::describe() const {
  StageRecord record;
  if (document_.queue().next_searches()) {
    record.kind = StageKind::kSeparate;
    return record;
  }
  const BeamQueue& pending = document_.queue().pending();
  record.move = pending.next_move(document_.world());
  if (!record.move) {
    const bool rim = !pending.empty() && pending.front_kind() == BeamQueue::Kind::kRim;
    record.kind = rim ? StageKind::kCloseRim : StageKind::kTime;
    return record;
  }
  const UnfinishedMove& unfinished = pending.unfinished();
  record.kind = kind_of(unfinished.stage);
  const std::vector<BodyId> bodies = cuttable(document_.world(), pending.front_stroke()->settings);
  if (unfinished.bodies >= bodies.size()) return record;
  record.body = bodies[unfinished.bodies];
  const Placement& placement = document_.world().body(record.body).placement;
  record.beam = sweep_beam(pending.front_stroke()->settings.laser,
                           {placement.to_body(record.move->from), placement.to_body(record.move->to)});
  return record;
}

// Executes all parts of a stage of many faces. Very many parts are several stages.
Result<StepResult> SingleStep::execute(StageKind kind, const Progress* progress) {
  constexpr size_t kMaxParts = 64;
  Result<StepResult> all = document_.step_stage(progress);
  const auto goes_on = [&] {
    if (kind == StageKind::kCloseRim) return document_.queue().pending().unfinished_rim().begun();
    return (kind == StageKind::kRefine || kind == StageKind::kRemove) && all->moves == 0 &&
           kind_of(document_.queue().pending().unfinished().stage) == kind;
  };
  for (size_t parts = 1; all && parts < kMaxParts && goes_on(); ++parts) {
    Result<StepResult> part = document_.step_stage(progress);
    if (!part) return part;
    all->delta.append(std::move(part->delta));
    all->statistics.add(part->statistics);
  }
  return all;
}

Result<StageRecord> SingleStep::next(const Progress* progress) {
  KERF_ASSERT(document_.waiting() > 0);
  StageRecord record = describe();
  if (record.kind == StageKind::kHit && !record.beam.empty() && !swept_) {
    swept_ = true;
    ++stages_;
    record.kind = StageKind::kSweep;
    return record;
  }
  Result<StepResult> done = execute(record.kind, progress);
  if (!done) {
    swept_ = false;
    return done.error();
  }
  ++stages_;
  record.done = std::move(*done);
  const UnfinishedMove& after = document_.queue().pending().unfinished();
  if (record.kind == StageKind::kHit || record.kind == StageKind::kHitAgain) record.hit = after.hit;
  if (record.kind == StageKind::kRefine) record.left = after.to_split.size();
  if (record.kind == StageKind::kRemove) record.left = after.hit.size() - after.removed;
  if (record.kind == StageKind::kSeparate) record.specks = count_specks(record.done.delta, document_);
  if (record.move && after.stage == UnfinishedMove::Stage::kFind) swept_ = false;
  record_work(record);
  return record;
}

void SingleStep::record_work(const StageRecord& record) {
  constexpr size_t kOfStage = 50;  // number of faces that cost as much as a stage itself
  const StepStatistics& statistics = record.done.statistics;
  work_ += statistics.faces_made + record.done.delta.removed_faces + kOfStage;
  const bool after_rim =
      record.kind == StageKind::kCloseRim && !document_.queue().pending().unfinished_rim().begun();
  const bool between_moves = record.done.moves > 0 && !swept_;
  if (document_.waiting() == 0 || !(after_rim || (between_moves && work_ >= work_between_marks_))) return;
  std::optional<Document::SavePoint> point = Document::SavePoint::create(document_);
  if (!point) return;
  places_.push_back({stages_, std::move(*point)});
  work_ = 0;
}

const SingleStep::Place* SingleStep::place_before(size_t stages) const {
  for (size_t i = places_.size(); i-- > 0;) {
    if (places_[i].stages < stages && places_[i].point.can_restore(document_)) return &places_[i];
  }
  return nullptr;
}

size_t SingleStep::resumes_after(size_t stages) const {
  const Place* place = place_before(stages);
  return place ? place->stages : 0;
}

Delta SingleStep::resume(size_t stages) {
  work_ = 0;
  swept_ = false;
  const Place* place = place_before(stages);
  stages_ = place ? place->stages : 0;
  std::erase_if(places_, [&](const Place& p) { return p.stages > stages_; });
  if (!place) {
    places_.clear();
    return document_.restart_stroke();
  }
  Delta delta = places_.back().point.restore(document_);
  for (Place& p : places_) p.point.follow(document_);  // the other save points are on the way there
  return delta;
}

Outcome SingleStep::go_back_to(size_t stages, const Told& told, const Progress* progress) {
  KERF_ASSERT(can_restart_stroke(document_) && stages <= stages_);
  Outcome outcome;
  std::vector<Delta> changes{resume(stages)};
  while (outcome.ok() && stages_ < stages) {
    const double share = static_cast<double>(stages_) / static_cast<double>(stages);
    if (progress && !progress->report(share)) {
      outcome.fail(cancelled());
    } else if (Result<StageRecord> stage = next()) {
      if (told) told(*stage);
      changes.push_back(std::move(stage->done.delta));
    } else {
      changes.front().replaced = true;
      outcome.fail(stage.error());
    }
  }
  outcome.delta = joined(std::move(changes));
  return outcome;
}

}  // namespace kerf
