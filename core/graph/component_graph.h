#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "core/world/world.h"

namespace kerf {

// A node of a component graph: a live face.
struct GraphNode {
  BodyId body;
  FaceId face;
  uint32_t piece = 0;  // label of its piece
  friend bool operator==(const GraphNode&, const GraphNode&) = default;
};

// The component graph of the paper, "Laser Mesh Separation" (figures 8 and 9): nodes are faces, and two faces
// are linked if they share an edge.
struct ComponentGraph {
  using Edge = std::array<uint32_t, 2>;  // two indices of nodes, the smaller one first

  std::vector<GraphNode> nodes;  // ascending by body and face
  std::vector<Edge> edges;       // ascending, each pair once
};

// The graph of all bodies, including hidden ones. At an edge of three or more faces each of them is linked
// with each other one. Linear in the number of faces, and quadratic in the number of faces on one edge.
ComponentGraph component_graph(const World& world);

// The graph of some pieces only. Precondition: their bodies exist. Linear in the size of these bodies.
ComponentGraph component_graph(const World& world, std::span<const PieceId> pieces);

// The links of a graph by node: those of node i are `linked` from index first[i] to first[i + 1], ascending.
class GraphLinks {
 public:
  GraphLinks() = default;
  // Precondition: every edge joins two different nodes below `nodes`. Linear time.
  GraphLinks(size_t nodes, std::span<const ComponentGraph::Edge> edges);

  size_t nodes() const { return first_.empty() ? 0 : first_.size() - 1; }
  std::span<const uint32_t> of(uint32_t node) const {
    return {linked_.data() + first_[node], linked_.data() + first_[node + 1]};
  }

 private:
  std::vector<uint32_t> first_, linked_;
};

}  // namespace kerf
