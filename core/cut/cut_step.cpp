#include "core/cut/cut_step.h"

#include "core/cut/step_state.h"

namespace kerf {

void StepFigures::add(const StepFigures& other) {
  tested.boxes += other.tested.boxes;
  tested.faces += other.tested.faces;
  faces_made += other.faces_made;
  query_s += other.query_s;
  refine_s += other.refine_s;
  remove_s += other.remove_s;
  update_tree_s += other.update_tree_s;
  separate_s += other.separate_s;
}

Result<StepResult> cut_step(World& world, const CutSettings& settings, std::span<const BeamMove> moves) {
  StepResult result;
  for (const BodyId id : world.ids()) {
    BodyStep step(id, world.body(id));
    for (const BeamMove& move : moves) {
      sweep(step, settings.laser, move);
      hit(step);
      const Result<bool> refined = refine(step, settings);
      if (!refined) return refined.error();
      if (*refined) hit(step);
      remove(step);
    }
    result.figures.add(step.figures);
    if (step.edited.empty()) continue;
    result.delta.removed_faces += step.removed_faces;
    result.delta.removed_area += step.removed_area;
    result.delta.bodies.push_back(separate(step));
    result.figures.separate_s += step.figures.separate_s;
  }
  return result;
}

}  // namespace kerf
