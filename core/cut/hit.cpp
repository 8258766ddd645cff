#include <algorithm>

#include "core/cut/step_state.h"
#include "core/cut/stopwatch.h"

namespace kerf {

void sweep(BodyStep& step, const Laser& laser, const BeamMove& move, bool in_body_frame) {
  const Placement& placement = step.body().placement;
  const BeamMove seen{placement.to_body(move.from), placement.to_body(move.to)};
  step.beam = sweep_beam(laser, in_body_frame ? move : seen);
}

void hit(BodyStep& step, std::vector<FaceId>& faces) {
  const Stopwatch watch(step.figures.query_s);
  faces.clear();
  for (const SweptCylinder& part : step.beam) {
    const QueryCounts counts = step.edit.touched(part, faces);
    ++step.figures.queries;
    step.figures.tested.boxes += counts.boxes;
    step.figures.tested.faces += counts.faces;
  }
  if (step.beam.size() == 1) return;
  std::sort(faces.begin(), faces.end());
  faces.erase(std::unique(faces.begin(), faces.end()), faces.end());
}

}  // namespace kerf
