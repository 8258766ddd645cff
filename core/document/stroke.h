#pragma once

#include <vector>

#include "core/cut/cut_step.h"
#include "core/document/beam_at.h"

namespace kerf {

// A stroke as it is cut: how, where its queued moves end, and what the beam has swept so far.
struct Stroke {
  CutSettings settings;
  BeamAt beam;                 // at the end of the moves that were queued
  std::vector<BeamMove> path;  // moves that were begun: those that only translate whole, others subdivided
};

}  // namespace kerf
