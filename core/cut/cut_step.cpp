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
    if (world.body(id).hidden) continue;
    BodyStep step(id, world.body(id));
    for (const BeamMove& move : moves) {
      sweep(step, settings.laser, move);
      hit(step);
      const Result<bool> refined = refine(step, settings, share_of(progress, done, done + share));
      if (!refined) return refined.error();
      if (*refined) hit(step);
      remove(step, settings.smooth());
      separate(step, settings.search_a_move);
      done += share;
    }
    end_step(step, result);
  }
  return result;
}

StepResult go_on_separating(World& world, size_t most) {
  StepResult result;
  for (const BodyId id : world.ids()) {
    BodyStep step(id, world.body(id));
    separate(step, most);
    end_step(step, result);
  }
  return result;
}

bool is_settled(const World& world) {
  const auto ids = world.ids();
  return std::all_of(ids.begin(), ids.end(), [&](BodyId id) { return is_settled(world.body(id)); });
}

namespace {

void sort_each_once(std::vector<FaceId>& faces) {
  std::sort(faces.begin(), faces.end());
  faces.erase(std::unique(faces.begin(), faces.end()), faces.end());
}

BodyDelta delta_of(BodyStep& step) {
  BodyDelta delta;
  delta.body = step.id;
  delta.new_pieces = std::move(step.new_pieces);
  sort_each_once(step.edited);
  for (const FaceId f : step.edited) (step.body.mesh.is_live(f) ? delta.born : delta.gone).push_back(f);
  sort_each_once(step.relabelled);
  std::erase_if(step.relabelled, [&](FaceId f) { return !step.body.mesh.is_live(f); });
  delta.relabelled = std::move(step.relabelled);
  return delta;
}

}  // namespace

void end_step(BodyStep& step, StepResult& result) {
  if (!step.edited.empty() || !step.relabelled.empty() || !step.new_pieces.empty()) {
    result.delta.removed_faces += step.removed_faces;
    result.delta.removed_area += step.removed_area;
    result.delta.bodies.push_back(delta_of(step));
    for (const FaceId f : result.delta.bodies.back().born) {
      step.figures.largest_cosine =
          std::max(step.figures.largest_cosine, largest_cosine(step.body.mesh.triangle(f)));
    }
  }
  result.figures.add(step.figures);
}

}  // namespace kerf
