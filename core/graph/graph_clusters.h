#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/graph/component_graph.h"

namespace kerf {

// Joins linked nodes of one kind until at most `most` clusters are left, the smallest clusters first, so that
// their sizes stay alike; fewer than `most` nodes are left apart. Nodes that no link joins stay apart, too:
// the result has at least one cluster for each connected set of nodes of one kind, even if these are more
// than `most`. The method is the coarsening of G. Karypis, V. Kumar: A fast and high quality multilevel
// scheme for partitioning irregular graphs (1998), with the sizes of clusters in place of the weights of
// edges.
//
// Returns by node the cluster that it belongs to; a cluster is a connected set of nodes of one kind, and they
// are numbered in the order of their lowest nodes. `kind` has one value for each node. Precondition:
// kind.size() == links.nodes(). O(n log n) in nodes and links.
std::vector<uint32_t> cluster_nodes(const GraphLinks& links, std::span<const uint32_t> kind, size_t most);

}  // namespace kerf
