#include "core/document/recorder.h"

#include <cassert>

namespace kerf {

void Recorder::open(World& world, size_t step, bool record) {
  assert(!step_);
  step_ = step;
  recording_ = record;
  if (record) world.begin_change();
}

std::optional<World::Change> Recorder::close(World& world) {
  assert(step_);
  step_.reset();
  if (!recording_) return std::nullopt;
  return world.end_change();
}

}  // namespace kerf
