#pragma once

#include <vector>

#include "core/base/ids.h"
#include "core/world/motion.h"
#include "core/world/placement.h"

namespace kerf {

class World;

// Where a body is and how it moves.
struct BodyState {
  BodyId id;
  Placement placement;
  Motion motion;
  friend bool operator==(const BodyState&, const BodyState&) = default;
};

// The states of the bodies of a world that move or have moved. O(bodies).
std::vector<BodyState> moved_bodies(const World& world);

}  // namespace kerf
