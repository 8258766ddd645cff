#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "core/document/document.h"
#include "core/tree/swept_cylinder.h"

namespace kerf {

struct StageRecord {
  enum class Kind {
    kSweep,     // computes the volumes that the beam sweeps in a body; changes nothing
    kHit,       // queries the tree for the faces that the beam touches
    kRefine,    // splits faces
    kHitAgain,  // repeats the query after the splits
    kRemove,    // removes faces
    kSeparate,  // searches for separated pieces
    kCloseRim,  // closes a smooth rim, or executes a part of that
    kTime,      // one tick
  };
  Kind kind = Kind::kSweep;
  // Set for the stages of a move: the move in world coordinates, the body, and the volumes that the beam
  // sweeps, in the frame of the body.
  std::optional<BeamMove> move;
  BodyId body;
  std::vector<SweptCylinder> beam;
  std::vector<FaceId> hit;  // of kHit and kHitAgain: the faces touched, each once
  size_t left = 0;          // number of faces left for further stages of the same kind
  size_t specks = 0;        // number of specks among the pieces that were cut off
  StepResult done;          // changes and statistics of the stage
};

// Executes the queue of a document stage by stage, and steps back within the last stroke. The result equals
// that of Document::step, to the bit. The document must outlive this object, and no other code may execute
// its queue.
class SingleStep {
 public:
  // `work`: the approximate number of faces split, removed and visited between two save points.
  explicit SingleStep(Document& document, size_t work = 30'000)
      : document_(document), work_between_marks_(work) {}

  // Executes the next stage. Fails like Document::step. Precondition: document.waiting() > 0.
  Result<StageRecord> next(const Progress* progress = nullptr);

  // The number of stages executed by next() since construction, minus those undone by go_back_to().
  size_t stages() const { return stages_; }

  using Told = std::function<void(const StageRecord&)>;
  // The stage from which go_back_to(stages) resumes: less than `stages` unless that is 0.
  size_t resumes_after(size_t stages) const;
  // Restores an earlier save point (see Document::SavePoint), or the start of the last history step (see
  // Document::restart_stroke), and executes that step up to its first `stages` stages. Calls `told` with each
  // executed stage. The outcome lists all changes, also on failure. If `progress` stops it, fewer stages
  // are executed. Costs as much as undoing the execution since the save point and executing the stages from
  // there. Preconditions: can_restart_stroke(document), stages() counts the stages of that step alone, and
  // `stages` does not exceed it.
  Outcome go_back_to(size_t stages, const Told& told = {}, const Progress* progress = nullptr);

 private:
  StageRecord describe() const;
  Result<StepResult> execute(StageRecord::Kind kind, const Progress* progress);

  // A save point at the start of a move, or after the rim was closed.
  struct Place {
    size_t stages = 0;
    Document::SavePoint point;
  };
  const Place* place_before(size_t stages) const;
  void record_work(const StageRecord& record);
  Delta resume(size_t stages);

  Document& document_;
  size_t work_between_marks_;
  std::vector<Place> places_;  // ascending by stages
  size_t work_ = 0;            // since the last save point
  size_t stages_ = 0;
  bool swept_ = false;  // the sweep of the current move through the current body was recorded
};

}  // namespace kerf
