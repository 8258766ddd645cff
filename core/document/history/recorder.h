#pragma once

#include <optional>

#include "core/world/world.h"

namespace kerf {

// Records the before-images of the step of the history that is being executed, which is called open.
class Recorder {
 public:
  // The open step, or nothing between close() and open().
  std::optional<size_t> step() const { return step_; }

  // Opens a step: changes from now on belong to it, and with `record` their before-images are recorded.
  // Precondition: no step is open.
  void open(World& world, size_t step, bool record);
  // Closes the open step and returns the changes since open() if they were recorded. Preconditions: a step is
  // open, and `world` is the one for which it was opened.
  std::optional<World::Change> close(World& world);
  // Discards the recording, because the world was replaced by another one.
  void abandon() { step_.reset(); }

 private:
  std::optional<size_t> step_;
  bool recording_ = false;
};

}  // namespace kerf
