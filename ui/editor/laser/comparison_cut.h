#pragma once

#include <optional>

#include "core/document/document.h"
#include "ui/editor/shared/laser_controls.h"

namespace kerf {

// Cuts the last stroke of a document a second time at a different resolution for comparison: "the same
// simulation, just with different parameters".
class TwinCut {
 public:
  // Follows the document: starts again if its last stroke or the resolution is different, and queues the
  // commands that the stroke has gained. Returns whether the world was replaced, so that everything that
  // follows it must start anew.
  bool follow(Document& first, const ResolutionControls& resolution);

  // Cuts up to `moves` queued moves as one step, like Document::step.
  Result<StepResult> step(size_t moves) { return document_.step(moves); }
  size_t waiting() const { return document_.waiting(); }

  // Whether the twin exists; it does not if the document is too large to be copied.
  bool there() const { return there_; }
  const World& world() const { return document_.world(); }
  const Resolution& resolution() const { return resolution_; }

  // Reports that the document was replaced.
  void forget() { *this = TwinCut(); }

 private:
  void begin(Document& first, const Resolution& resolution);

  Document document_;
  Resolution resolution_;
  bool there_ = false, begun_ = false;
  size_t revision_ = 0;  // of the first
  size_t commands_ = 0;  // of its last stroke that are followed
};

}  // namespace kerf
