#pragma once

#include <algorithm>
#include <span>
#include <vector>

#include "core/cut/cut_step.h"
#include "tests/bench/peer.h"

namespace kerf::bench {

// A straight slot through the middle of a box, across its longest side, with the beam along the shortest.
class Slot {
 public:
  explicit Slot(const Bounds& box);

  SlotBox box() const { return {low_, high_, middle_, across_, radius()}; }
  std::vector<BeamMove> path(int moves) const;

  // With the rim of faces; with a smooth one; and as a user would cut who wants the piece: the removed part
  // may exceed the beam by half of its width.
  CutSettings settings() const;
  CutSettings smooth_settings() const;
  CutSettings quick_settings() const;

 private:
  double length() const { return high_[across_] - low_[across_]; }
  double radius() const;
  Pose pose(double share) const;

  Vec3 low_, high_, middle_;
  int along_ = 0, across_ = 0, beam_ = 0;
};

// The steps of a cut, and the processor time that they take.
struct Walked {
  std::vector<double> steps;  // s, of all
  std::vector<bool> removed;  // by step: true if it removed faces
  double seconds = 0;         // of all steps
  size_t turned = 0;          // new and removed faces
  size_t walls = 0;           // faces of walls
  size_t left_open = 0;       // parts of solids that no wall closes

  double per_face() const { return seconds / static_cast<double>(std::max<size_t>(turned, 1)); }
  double longest() const { return *std::max_element(steps.begin(), steps.end()); }
  // A quantile of the steps that removed faces; 0 if there are none.
  double quantile(double share) const;
};

// Cuts along the path, closes the rim and searches for pieces, in steps.
Walked walk(World& world, const CutSettings& settings, std::span<const BeamMove> path);

}  // namespace kerf::bench
