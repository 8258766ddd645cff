#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "core/document/document.h"
#include "core/mesh/files/mesh_format.h"
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
    kCloseRim,  // the end of a stroke with a smooth rim, or a part of it
    kTime,      // a tick passes
  };
  Kind kind = Kind::kSweep;
  // Set for the stages of a move: the move in world coordinates, the body, and the volumes that
  // the beam sweeps, in the frame of the body.
  std::optional<BeamMove> move;
  BodyId body;
  std::vector<SweptCylinder> beam;
  std::vector<FaceId> hit;  // of kHit and kHitAgain: the faces that the beam touches, each once
  size_t left = 0;          // faces that are left for further stages of the same kind, if there are thousands
  size_t specks = 0;        // of the pieces that came off, those that are specks
  StepResult done;          // what the stage changed, and its statistics
};

// A description of the stage for the user: one sentence. `unit` is the one in which the work is shown.
std::string words(const StageRecord& record, FileUnit unit);

// Executes the queue of a document stage by stage, and goes back in the last stroke. The result is the same
// as that of Document::step, to the bit. The document must outlive it, and nobody else may execute its queue
// meanwhile.
class SingleStep {
 public:
  // `work` is about how many faces are split, removed and looked at between two places from which it goes on
  // after it has gone back.
  explicit SingleStep(Document& document, size_t work = 30'000)
      : document_(document), work_between_marks_(work) {}

  // Executes the next stage. Fails like Document::step. Precondition: document.waiting() > 0.
  Result<StageRecord> next(const Progress* progress = nullptr);

  // The number of stages that next() has executed since the construction, less those that go_back_to() took
  // back.
  size_t stages() const { return stages_; }

  using Told = std::function<void(const StageRecord&)>;
  // The number of stages after which go_back_to(stages) takes the execution up again: less than `stages`
  // unless that is 0.
  size_t resumes_after(size_t stages) const;
  // Goes back to a place before (see Document::go_back_to), or to the start of the last step of the history
  // (see Document::start_again), and executes it up to its first `stages` stages. `told` is called with each
  // stage that is executed. The outcome lists all changes, also on failure. If `progress` stops it, fewer
  // stages are executed. Costs as much as undoing what was executed since that place, and executing the
  // stages from there.
  // Preconditions: document.can_start_again(), stages() counts the stages of that step alone, and `stages` is
  // at most this number.
  Outcome go_back_to(size_t stages, const Told& told = {}, const Progress* progress = nullptr);

 private:
  StageRecord describe() const;
  Result<StepResult> execute(StageRecord::Kind kind, const Progress* progress);

  // A place at which a move begins, or after the rim was closed.
  struct Place {
    size_t stages = 0;
    Document::Mark mark;
  };
  const Place* place_before(size_t stages) const;
  void record_work(const StageRecord& record);
  Delta resume(size_t stages);

  Document& document_;
  size_t work_between_marks_;
  std::vector<Place> places_;  // ascending by stages
  size_t work_ = 0;            // since the last place
  size_t stages_ = 0;
  bool swept_ = false;  // the sweep of the present move through the present body was recorded
};

}  // namespace kerf
