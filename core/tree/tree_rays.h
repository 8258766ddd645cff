#pragma once

#include <span>

#include "core/tree/swept_cylinder.h"
#include "core/tree/tree_store.h"
#include "core/tree/walks.h"

namespace kerf {

// Prepares a traversal by one to four rays of equal direction; `range` is in metres along them. Returns false
// if they miss the tree's bounds. Sets all of `out` but its positions.
bool prepare_rays(const TreeStore& tree, std::span<const Pose> rays, Interval range, RayQuery& out);

}  // namespace kerf
