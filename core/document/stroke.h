#pragma once

#include <vector>

#include "core/cut/cut_step.h"
#include "core/document/beam_at.h"

namespace kerf {

// A stroke while it is cut: its settings, the end of its queued moves, and the path that the beam has swept.
struct Stroke {
  CutSettings settings;
  BeamAt beam;                 // the pose and time at the end of the last queued move
  std::vector<BeamMove> path;  // the moves that were begun; moves that rotate the beam are subdivided
};

}  // namespace kerf
