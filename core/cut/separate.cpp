#include "core/cut/step_state.h"
#include "core/cut/stopwatch.h"

namespace kerf {

size_t separate(BodyStep& step, size_t most) {
  const Stopwatch watch(step.figures.separate_s);
  const SettleResult result = settle(step.body, most);
  step.new_pieces.insert(step.new_pieces.end(), result.new_pieces.begin(), result.new_pieces.end());
  step.relabelled.insert(step.relabelled.end(), result.relabelled.begin(), result.relabelled.end());
  return result.looked_at + result.relabelled.size();
}

}  // namespace kerf
