#pragma once

#include <vector>

#include "core/base/ids.h"
#include "core/laser/laser.h"
#include "core/world/world.h"

namespace kerf {

// The bodies that a beam can cut: all that are not hidden, in the order of World::ids(). O(bodies).
std::vector<BodyId> cuttable(const World& world);

// Returns whether a beam touches a face of such a body during a move in world coordinates. If not, the move
// removes nothing and heats nothing. A move of very many parts (see subdivide) is taken for one that does.
// O(log n) for each part. Preconditions: directions are unit vectors and not opposite.
bool meets_anything(const World& world, const Laser& laser, const BeamMove& move);
// The same for a beam that stands still.
bool meets_anything(const World& world, const Laser& laser, const Pose& pose);

}  // namespace kerf
