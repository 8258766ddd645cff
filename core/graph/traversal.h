#pragma once

#include <cstdint>
#include <vector>

#include "core/graph/component_graph.h"

namespace kerf {

// The test of the paper ("Laser Mesh Separation") of whether a mesh has been cut through: a breadth-first
// search marks the nodes that can be reached from one of them. If it marks fewer than there are, the marked
// and the unmarked nodes are two sets between which no link exists.
//
// Kerf itself decides by the loops that a cut closes and searches only where one did (see CutLoops and
// PartSearch); the traversal shows what the paper does, and the tests hold the two against each other.
struct Traversal {
  static constexpr uint32_t kNone = 0xffffffffu;

  std::vector<uint32_t> order;  // the nodes in the order in which they were marked, the start first
  std::vector<uint32_t> from;   // by index of `order`: the node over whose link it was reached; kNone: start
  std::vector<uint32_t> rank;   // by node: its index in `order`, or kNone if it was not reached

  size_t reached() const { return order.size(); }
};

// Traverses the graph from a node. The links of a node are followed in ascending order, so that the order is
// a function of the graph alone. Precondition: start < links.nodes(). Linear time.
Traversal traverse(const GraphLinks& links, uint32_t start);

// The components of a graph: the result of traversals from the lowest node that none has reached yet, until
// there is none left.
struct GraphComponents {
  std::vector<uint32_t> of;    // by node: the number of its component, in the order of their lowest nodes
  std::vector<uint32_t> size;  // by component: its nodes
};
GraphComponents find_components(const GraphLinks& links);

}  // namespace kerf
