#include "core/document/single_step.h"

#include <cassert>

#include "core/base/length_text.h"
#include "core/cut/cuttable.h"

namespace kerf {

namespace {

using Kind = StageRecord::Kind;

Kind kind_of(UnfinishedMove::Stage stage) {
  switch (stage) {
    case UnfinishedMove::Stage::kFind:
      return Kind::kHit;
    case UnfinishedMove::Stage::kRefine:
      return Kind::kRefine;
    case UnfinishedMove::Stage::kFindAgain:
      return Kind::kHitAgain;
    case UnfinishedMove::Stage::kRemove:
      return Kind::kRemove;
    case UnfinishedMove::Stage::kSeparate:
      return Kind::kSeparate;
  }
  return Kind::kHit;
}

std::string number(size_t count, const char* noun) {
  return std::to_string(count) + " " + noun + (count == 1 ? "" : "s");
}

size_t new_pieces(const Delta& delta) {
  size_t all = 0;
  for (const BodyDelta& body : delta.bodies) all += body.new_pieces.size();
  return all;
}

std::string left_words(const StageRecord& record) {
  return record.left > 0 ? " " + number(record.left, "face") + " are left for this stage." : "";
}

}  // namespace

// Of the stage that comes next, before it is executed.
StageRecord SingleStep::describe() const {
  StageRecord record;
  if (document_.next_searches()) {
    record.kind = Kind::kSeparate;
    return record;
  }
  record.move = document_.next_move();
  if (!record.move) {
    record.kind = document_.next_closes_rim() ? Kind::kCloseRim : Kind::kTime;
    return record;
  }
  const UnfinishedMove& unfinished = document_.unfinished_move();
  record.kind = kind_of(unfinished.stage);
  const std::vector<BodyId> bodies = cuttable(document_.world());
  if (unfinished.bodies >= bodies.size()) return record;
  record.body = bodies[unfinished.bodies];
  const Placement& placement = document_.world().body(record.body).placement;
  record.beam = sweep_beam(document_.next_settings().laser,
                           {placement.to_body(record.move->from), placement.to_body(record.move->to)});
  return record;
}

Result<StageRecord> SingleStep::next(const Progress* progress) {
  assert(document_.waiting() > 0);
  StageRecord record = describe();
  if (record.kind == Kind::kHit && !record.beam.empty() && !swept_) {
    swept_ = true;
    record.kind = Kind::kSweep;
    return record;
  }
  Result<StepResult> done = document_.step_stage(progress);
  if (!done) {
    swept_ = false;
    return done.error();
  }
  record.done = std::move(*done);
  const UnfinishedMove& after = document_.unfinished_move();
  if (record.kind == Kind::kHit || record.kind == Kind::kHitAgain) record.hit = after.hit;
  if (record.kind == Kind::kRefine) record.left = after.to_split.size();
  if (record.kind == Kind::kRemove) record.left = after.hit.size() - after.removed;
  if (record.move && after.stage == UnfinishedMove::Stage::kFind) swept_ = false;
  return record;
}

std::string words(const StageRecord& record) {
  const StepFigures& figures = record.done.figures;
  switch (record.kind) {
    case Kind::kSweep:
      return "Sweep: the origin of the beam moves by " +
             length_text(glm::length(record.move->to.origin - record.move->from.origin)) + ", which sweeps " +
             number(record.beam.size(), "volume") + " of radius " +
             length_text(record.beam.front().radius()) + ".";
    case Kind::kHit:
    case Kind::kHitAgain:
      return std::string(record.kind == Kind::kHit ? "Hit" : "Hit again, after the splits") +
             ": the beam touches " + number(record.hit.size(), "face") + "; the tree tested " +
             number(figures.tested.boxes, "box slot") + " and " + number(figures.tested.faces, "face") + ".";
    case Kind::kRefine:
      return "Refine: " + number(figures.faces_made, "face") + " were made by splits." + left_words(record);
    case Kind::kRemove:
      return "Remove: " + number(record.done.delta.removed_faces, "face") + " were removed." +
             left_words(record);
    case Kind::kSeparate:
      return "Separate: " + number(new_pieces(record.done.delta), "piece") + " came off.";
    case Kind::kCloseRim:
      return "Close the rim: " + number(record.done.delta.removed_faces, "face") +
             " inside the boundary of the stroke were removed.";
    case Kind::kTime:
      return "Time: a tick passed.";
  }
  return {};
}

}  // namespace kerf
