#pragma once

#include "core/base/progress.h"
#include "core/tree/tree_store.h"

namespace kerf {

// Fills an empty store with a tree over the live faces of a mesh: top-down, each node opened at its largest
// child until it is full, each split the best of the surface area heuristic over binned centroids (I. Wald:
// On fast construction of SAH-based bounding volume hierarchies, 2007; the cost of a part is its area times
// the blocks that its faces fill). O(n log n). `progress` may be null. False when it was stopped: the store
// is good for nothing then.
bool build_tree(TreeStore& store, const Mesh& mesh, const Progress* progress);

}  // namespace kerf
