#pragma once

#include "core/document/document.h"
#include "ui/editor/shared/laser_controls.h"

namespace kerf {

// Cuts the last stroke of a document again at a second resolution, for comparison: "the same simulation,
// just with different parameters".
class TwinCut {
 public:
  // Restarts if the last stroke of the document, or an uncut document, or the resolution has changed, and
  // queues the commands added to the stroke since the last call. Returns true if world() was replaced, so
  // that everything derived from it must be rebuilt.
  bool follow(Document& first, const ResolutionControls& resolution);

  // Executes up to `moves` queued moves as one step, like Document::step.
  Result<StepResult> step(size_t moves) { return document_.step(moves); }
  size_t waiting() const { return document_.waiting(); }

  // Returns false if the world before the stroke cannot be copied (see no_comparison_reason()).
  bool there() const { return there_; }
  const World& world() const { return document_.world(); }
  // Returns the number of faces that the stroke has created so far.
  size_t faces_made() const {
    const UndoStack& history = document_.history();
    return history.last_cut() ? history.step(*history.last_cut()).totals().statistics.faces_made : 0;
  }
  const Resolution& resolution() const { return resolution_; }

  // Discards the twin because the document was replaced.
  void forget() { *this = TwinCut(); }

 private:
  void begin(Document& first, const Resolution& resolution);

  Document document_;
  Resolution resolution_;
  bool there_ = false, begun_ = false;
  size_t revision_ = 0;  // of the document
  size_t position_ = 0;  // of its history
  size_t commands_ = 0;  // of its last stroke that were queued
};

// Returns why the document has no twin, as a label. Precondition: TwinCut::there() returns false after
// TwinCut::follow().
const char* no_comparison_reason(const Document& document);

}  // namespace kerf
