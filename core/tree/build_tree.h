#pragma once

#include "core/base/progress.h"
#include "core/tree/tree_store.h"

namespace kerf {

// The shape of a tree; the default gives the fastest queries.
struct TreeShape {
  uint32_t block = kBlockWidth;  // faces in a block, at most; 1 .. kBlockWidth
  bool halved = false;           // ranges are split at their middle, in whatever order their faces are
};

// Builds a tree over the live faces of a mesh, top-down: the child with the largest area is split until the
// node is full, and each split is the best one of the surface area heuristic over binned centroids (I. Wald:
// On fast construction of SAH-based bounding volume hierarchies, 2007), where the cost of a part is its area
// times the number of blocks that its faces fill. O(n log n). `progress` may be null. Returns false when it
// was stopped; the store must be discarded then. Precondition: the store is empty.
bool build_tree(TreeStore& store, const Mesh& mesh, const TreeFrame& frame, const Progress* progress,
                TreeShape shape = {});

}  // namespace kerf
