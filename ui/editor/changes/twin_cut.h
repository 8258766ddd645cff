#pragma once

#include <optional>

#include "core/document/document.h"
#include "ui/editor/tools/laser_controls.h"

namespace kerf {

// The last stroke of a document cut a second time, at a resolution of its own and beside the first: "the same
// simulation, just with different parameters".
class TwinCut {
 public:
  // Takes on what the first has come to: its stroke is begun anew where it is another one or the resolution
  // has changed, and goes on where it has gone on. Whether the world is a new one for everything that follows
  // it. The commands wait to be stepped.
  bool follow(Document& first, const ResolutionControls& resolution);

  // Up to so many moves of the beam as one step, as Document::step.
  Result<StepResult> step(size_t moves) { return document_.step(moves); }
  size_t waiting() const { return document_.waiting(); }

  // False where the first is too large to be copied; there is no world then.
  bool there() const { return there_; }
  const World& world() const { return document_.world(); }
  const Resolution& resolution() const { return resolution_; }

  // The first is another document now.
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
