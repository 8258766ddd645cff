#pragma once

#include <optional>

#include "core/world/world.h"

namespace kerf {

// Knows which step of a history changes the world at the moment, and records before-images of what it
// changes where they are wanted.
class Recorder {
 public:
  // The step that is open; none between close and open.
  std::optional<size_t> step() const { return step_; }

  // What changes from here on is changed by this step. Precondition: no step is open.
  void open(World& world, size_t step, bool record);
  // Closes the open step. What it changed since open, where that was recorded. Precondition: a step is open,
  // and `world` is the one that it was opened for.
  std::optional<World::Change> close(World& world);
  // The world is another one: what was recorded is of no use.
  void abandon() { step_.reset(); }

 private:
  std::optional<size_t> step_;
  bool recording_ = false;
};

}  // namespace kerf
