#pragma once

#include <vector>

#include "core/base/ids.h"
#include "core/laser/laser.h"
#include "core/world/world.h"

namespace kerf {

// The bodies that a beam can cut: all that are not hidden, in the order of World::ids(). O(bodies).
std::vector<BodyId> cuttable(const World& world);

// Whether a beam that stands still at a pose, in world coordinates, touches a face of such a body: a stroke
// of this pose alone removes nothing where it does not. O(faces), because queries of the tree mark it.
// Precondition: the direction is a unit vector.
bool meets_anything(const World& world, const Laser& laser, const Pose& pose);

}  // namespace kerf
