#pragma once

#include <vector>

#include "core/base/ids.h"
#include "core/world/world.h"

namespace kerf {

// The bodies that the beam meets: all that are not hidden, in the order in which they were added. O(bodies).
std::vector<BodyId> cuttable(const World& world);

}  // namespace kerf
