#pragma once

#include <vector>

#include "core/base/ids.h"
#include "core/world/world.h"

namespace kerf {

// The bodies that a beam can cut: all that are not hidden, in the order of World::ids(). O(bodies).
std::vector<BodyId> cuttable(const World& world);

}  // namespace kerf
