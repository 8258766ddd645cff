#pragma once

#include <span>

#include "core/tree/swept_cylinder.h"
#include "core/tree/tree_store.h"
#include "core/tree/walks.h"

namespace kerf {

// Makes parallel rays ready for a walk: one to four rays of equal direction, within the range. False if they
// pass the tree by.
bool prepare_rays(const TreeStore& tree, std::span<const Pose> rays, Interval range, RayQuery& out);

}  // namespace kerf
