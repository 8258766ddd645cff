#pragma once

#include <vector>

#include "core/world/world.h"

namespace kerf::test {

// The bodies of a world that hold more than what hangs together by edges and joints, i.e. from which a part
// has to come off: of those that were loaded as `loaded_as`, ascending. Found by a complete search of the
// faces and joints, which uses neither the labels of pieces nor what is kept of removals.
//
// Two parts of what was connected as loaded have to come apart whatever joints hold them. Components that no
// joint names go with the largest part of their body. Welds hold over other bodies, too; hinges and hubs hold
// what is in one body.
std::vector<BodyId> bodies_with_free_parts(const World& world, BodyId loaded_as);

}  // namespace kerf::test
