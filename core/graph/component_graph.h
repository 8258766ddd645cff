#pragma once

#include <array>
#include <cstdint>
#include <optional>
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

// The component graph of the paper, "Laser Mesh Separation" (figures 8, 9): faces, linked if they share an
// edge.
struct ComponentGraph {
  using Edge = std::array<uint32_t, 2>;  // two indices of nodes, the smaller one first

  std::vector<GraphNode> nodes;  // ascending by body and face
  std::vector<Edge> edges;       // ascending, each pair once
};

// Returns the graph of all bodies, including hidden ones. At an edge of three or more faces each is linked
// with each other one. Linear in the number of faces, and quadratic in the number of faces on one edge.
ComponentGraph component_graph(const World& world);

// Returns the graph of some pieces. Precondition: their bodies exist. Linear in the size of these bodies.
ComponentGraph component_graph(const World& world, std::span<const PieceId> pieces);

// The links of a graph by node, ascending.
class GraphLinks {
 public:
  GraphLinks() = default;
  // Precondition: every edge joins two different nodes below `nodes`. O(n).
  GraphLinks(size_t nodes, std::span<const ComponentGraph::Edge> edges);

  size_t nodes() const { return first_.empty() ? 0 : first_.size() - 1; }
  std::span<const uint32_t> of(uint32_t node) const {
    return {linked_.data() + first_[node], linked_.data() + first_[node + 1]};
  }

 private:
  std::vector<uint32_t> first_, linked_;
};

// The test of the paper ("Laser Mesh Separation") whether a mesh has been cut through: a breadth-first search
// marks the nodes reachable from one of them. If it does not mark all, no link exists between the marked and
// the unmarked nodes.
//
// Kerf itself decides by the loops that a cut closes, and searches only if one did (see CutLoops and
// PartSearch); the traversal displays the method of the paper, and tests compare the two.
struct Traversal {
  static constexpr uint32_t kNone = 0xffffffffu;

  std::vector<uint32_t> order;  // the nodes in the order in which they were marked, the start first
  std::vector<uint32_t> from;   // by index of `order`: the predecessor of the node; kNone: start
  std::vector<uint32_t> rank;   // by node: its index in `order`, or kNone if it was not reached

  size_t reached() const { return order.size(); }
};

// Traverses the graph from a node. Links are followed in ascending order, so that the result is a function of
// the graph alone. Precondition: start < links.nodes(). O(n).
Traversal traverse(const GraphLinks& links, uint32_t start);

// The components of a graph, by traversals from the lowest node not yet reached.
struct GraphComponents {
  std::vector<uint32_t> of;    // by node: the number of its component, in the order of their lowest nodes
  std::vector<uint32_t> size;  // by component: number of nodes
};
GraphComponents find_components(const GraphLinks& links);

// The reason why a piece stays in place and in one part.
enum class Holder {
  kNothing,  // the piece is detached: it stays only until it is moved or time passes
  kItself,   // a connected body on which nothing else acts
  kBody,     // several unconnected parts of one body, which move together
  kPin,      // the body is pinned
};

// Returns "nothing", "itself", "body" or "pin".
const char* name_of(Holder holder);

// A node of the graph of pieces.
struct PieceNode {
  PieceId piece;
  // The piece from which it was cut off, by its id at the current history position, and the step that did it.
  // nullopt for the remainder of a body, and if unknown (see HistoryStep::Totals).
  std::optional<PieceId> came_off;
  size_t step = 0;
  Holder held_by = Holder::kNothing;
  size_t parts = 1;   // components of its faces
  size_t beside = 0;  // other pieces of the same body that have faces
};

// Returns the pieces that have faces, ascending, with `came_off` unset. O(pieces + loaded components).
std::vector<PieceNode> piece_nodes(const World& world);

}  // namespace kerf
