#include <algorithm>

#include "core/cut/step_state.h"
#include "core/cut/stopwatch.h"

namespace kerf {

void sweep(BodyStep& step, const Laser& laser, const BeamMove& move) {
  const Placement& placement = step.body.placement;
  step.beam = sweep_beam(laser, {placement.to_body(move.from), placement.to_body(move.to)});
}

void hit(BodyStep& step) {
  const Stopwatch watch(step.figures.query_s);
  step.hit.clear();
  for (const SweptCylinder& part : step.beam) {
    const QueryCounts counts = step.body.tree.touched(step.body.mesh, part, step.hit);
    step.figures.tested.boxes += counts.boxes;
    step.figures.tested.faces += counts.faces;
  }
  if (step.beam.size() == 1) return;
  std::sort(step.hit.begin(), step.hit.end());
  step.hit.erase(std::unique(step.hit.begin(), step.hit.end()), step.hit.end());
}

}  // namespace kerf
