#include <algorithm>

#include "core/cut/step_state.h"
#include "core/cut/stopwatch.h"

namespace kerf {

BodyDelta separate(BodyStep& step, size_t most) {
  const Stopwatch watch(step.figures.separate_s);
  BodyDelta delta;
  delta.body = step.id;
  SettleResult result = settle(step.body, most);
  delta.new_pieces = std::move(result.new_pieces);
  delta.relabelled = std::move(result.relabelled);

  std::sort(step.edited.begin(), step.edited.end());
  step.edited.erase(std::unique(step.edited.begin(), step.edited.end()), step.edited.end());
  for (const FaceId f : step.edited) (step.body.mesh.is_live(f) ? delta.born : delta.gone).push_back(f);
  return delta;
}

}  // namespace kerf
