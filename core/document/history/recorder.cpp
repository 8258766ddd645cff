#include "core/document/history/recorder.h"

#include "core/base/assert.h"

namespace kerf {

void Recorder::open(World& world, size_t step, bool record) {
  KERF_ASSERT(!step_);
  step_ = step;
  recording_ = record;
  if (record) world.begin_change();
}

std::optional<World::Change> Recorder::close(World& world) {
  KERF_ASSERT(step_);
  step_.reset();
  if (!recording_) return std::nullopt;
  return world.end_change();
}

}  // namespace kerf
