#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "core/document/document.h"
#include "core/tree/swept_cylinder.h"

namespace kerf {

// One stage of the execution of a document, with what it did.
struct StageRecord {
  enum class Kind {
    kSweep,     // the volumes that the beam sweeps in a body; changes nothing
    kHit,       // the query of the tree for the faces that the beam touches
    kRefine,    // faces are split
    kHitAgain,  // the same query after the splits
    kRemove,    // faces are removed
    kSeparate,  // the search for separated pieces
    kCloseRim,  // the end of a stroke with a smooth rim
    kTime,      // a tick passes
  };
  Kind kind = Kind::kSweep;
  // Of the stages of a move, otherwise empty: the move in world coordinates, the body, and the volumes that
  // the beam sweeps, in the frame of the body.
  std::optional<BeamMove> move;
  BodyId body;
  std::vector<SweptCylinder> beam;
  std::vector<FaceId> hit;  // of kHit and kHitAgain: the faces that the beam touches, each once
  size_t left = 0;          // faces that are left for further stages of the same kind, if there are thousands
  StepResult done;          // what the stage changed, and its figures
};

// A description of the stage for the user: one sentence.
std::string words(const StageRecord& record);

// Executes the queue of a document stage by stage, and goes back in the last stroke. The result is the same
// as that of Document::step, to the bit. The document must outlive it, and nobody else may execute its queue
// meanwhile.
class SingleStep {
 public:
  explicit SingleStep(Document& document) : document_(document) {}

  // Executes the next stage. Fails like Document::step. Precondition: document.waiting() > 0.
  Result<StageRecord> next(const Progress* progress = nullptr);

  // The number of stages that next() has executed since the construction, less those that go_back_to() took
  // back.
  size_t stages() const { return stages_; }

  using Told = std::function<void(const StageRecord&)>;
  // Starts the last step of the history again (see Document::start_again), and executes its first `stages`
  // stages. `told` is called with each of them. The outcome lists all changes, also on failure. If `progress`
  // stops it, fewer stages are executed. Costs as much as undoing the step and executing these stages.
  // Preconditions: document.can_start_again(), stages() counts the stages of that step alone, and `stages` is
  // at most this number.
  Outcome go_back_to(size_t stages, const Told& told = {}, const Progress* progress = nullptr);

 private:
  StageRecord describe() const;
  Result<StepResult> execute(StageRecord::Kind kind, const Progress* progress);

  Document& document_;
  size_t stages_ = 0;
  bool swept_ = false;  // the sweep of the present move through the present body was recorded
};

}  // namespace kerf
