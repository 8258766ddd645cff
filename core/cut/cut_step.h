#pragma once

#include <span>

#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/laser/laser.h"
#include "core/world/delta.h"
#include "core/world/world.h"

namespace kerf {

// How a face is split.
enum class Scheme {
  kOneToFour,    // in four, closed with green pairs (see OneToFour)
  kLongestEdge,  // in two at its longest edge (see longest_edge.h)
};

// How finely faces are split where the beam touches them before they are removed.
struct Resolution {
  enum class Rule {
    kTargetEdge,  // until the longest edge is at most target_edge
    kTolerance,   // until taking the face away overshoots the beam by at most `tolerance`
    kDepth,       // until the face lies `depth` levels under its base face; 0 removes base faces whole
  };
  Scheme scheme = Scheme::kLongestEdge;
  Rule rule = Rule::kTargetEdge;
  double target_edge = 0.0025;  // m, > 0
  double tolerance = 0.00125;   // m, > 0
  int depth = 4;                // levels, 0 .. kLargestDepth: a split in four, or two in two

  static constexpr int kLargestDepth = 24;
};

struct CutSettings {
  Laser laser;
  Resolution resolution;
  size_t most_faces = 20'000'000;  // a cut that would make more live faces than this stops
};

// What a step looked at, made and took, and how long its stages took (seconds).
struct StepFigures {
  QueryCounts tested;
  size_t faces_made = 0;
  double query_s = 0, refine_s = 0, remove_s = 0, update_tree_s = 0, separate_s = 0;

  void add(const StepFigures& other);
};

struct StepResult {
  Delta delta;
  StepFigures figures;
};

// One step of a cut through all bodies: for each move of the beam in turn the faces that it touches are found
// (hit), split until they are fine enough or wholly within the beam (refine), and removed; then what came
// apart gets labels of its own (separate). Topology changes nowhere else. Moves are in world coordinates.
//
// Fails when settings.most_faces is reached and when `progress` stops it; what was cut until then stays cut,
// and the delta is lost, so that everything that follows the world must look at it anew.
Result<StepResult> cut_step(World& world, const CutSettings& settings, std::span<const BeamMove> moves,
                            const Progress* progress = nullptr);

}  // namespace kerf
