#include "core/cut/cut_step.h"

#include <algorithm>

#include "core/cut/step_state.h"

namespace kerf {

void StepFigures::add(const StepFigures& other) {
  tested.boxes += other.tested.boxes;
  tested.faces += other.tested.faces;
  faces_made += other.faces_made;
  largest_cosine = std::max(largest_cosine, other.largest_cosine);
  query_s += other.query_s;
  refine_s += other.refine_s;
  remove_s += other.remove_s;
  update_tree_s += other.update_tree_s;
  separate_s += other.separate_s;
}

Result<StepResult> cut_step(World& world, const CutSettings& settings, std::span<const BeamMove> moves,
                            const Progress* progress) {
  StepResult result;
  const auto ids = world.ids();
  const double share = 1 / static_cast<double>(std::max<size_t>(1, ids.size() * moves.size()));
  double done = 0;
  for (const BodyId id : ids) {
    BodyStep step(id, world.body(id));
    for (const BeamMove& move : moves) {
      sweep(step, settings.laser, move);
      hit(step);
      const Result<bool> refined = refine(step, settings, share_of(progress, done, done + share));
      if (!refined) return refined.error();
      if (*refined) hit(step);
      remove(step, settings.smooth());
      done += share;
    }
    end_step(step, settings.search_a_step, result);
  }
  return result;
}

StepResult go_on_separating(World& world, size_t most) {
  StepResult result;
  for (const BodyId id : world.ids()) {
    BodyStep step(id, world.body(id));
    end_step(step, most, result);
  }
  return result;
}

bool is_settled(const World& world) {
  const auto ids = world.ids();
  return std::all_of(ids.begin(), ids.end(), [&](BodyId id) { return is_settled(world.body(id)); });
}

void end_step(BodyStep& step, size_t most, StepResult& result) {
  if (!step.edited.empty() || !is_settled(step.body)) {
    result.delta.removed_faces += step.removed_faces;
    result.delta.removed_area += step.removed_area;
    result.delta.bodies.push_back(separate(step, most));
    for (const FaceId f : result.delta.bodies.back().born) {
      step.figures.largest_cosine =
          std::max(step.figures.largest_cosine, largest_cosine(step.body.mesh.triangle(f)));
    }
  }
  result.figures.add(step.figures);
}

}  // namespace kerf
