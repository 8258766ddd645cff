#pragma once

#include <array>
#include <cassert>
#include <cstdint>
#include <map>
#include <optional>
#include <ostream>
#include <span>
#include <vector>

#include "core/base/geometry.h"
#include "core/world/world.h"
#include "core/world/world_delta.h"

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
    assert(node < nodes());
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

// Export of a component graph as text. Faces and pieces are numbered over all bodies of the world: a face by
// its slot plus the face slots of the preceding bodies, a piece by its label plus the pieces of these bodies,
// so that in a world of one body both are the numbers shown by the editor. History steps count from 1.
//
// Precondition of both functions: the graph and the pieces are those of `world`. O(n), without copying the
// graph.

// Writes JSON: {"nodes": [{"face": 0, "piece": 0, "body": 0}], "edges": [[0, 1]], "bodies": [{"name": "car",
// "first_face": 0, "first_piece": 0}], "pieces": [{"piece": 3, "name": "car 3", "body": 0, "faces": 120,
// "came_off": 0, "step": 2, "held_by": "nothing", "parts": 1}]}. Edges are indices of nodes; bodies have the
// numbers of their first face and piece; pieces have the piece they were cut off and the step, both null if
// unknown, and what holds them (see name_of(Holder)).
void write_graph_json(const ComponentGraph& graph, std::span<const PieceNode> pieces, const World& world,
                      std::ostream& out);

// Writes the DOT language of Graphviz (E. R. Gansner, S. C. North: An open graph visualization system, 2000):
// faces as nodes named by number, with a colour for each piece; pieces as boxes labelled with what holds
// them, with an arrow from a piece to each one cut off it.
void write_graph_dot(const ComponentGraph& graph, std::span<const PieceNode> pieces, const World& world,
                     std::ostream& out);

// The component graph of bodies and of the faces that a stroke removed from them.
struct CutGraph {
  std::vector<GraphNode> nodes;             // live faces, then removed ones in the order of removal
  uint32_t live = 0;                        // the number of live faces
  std::vector<ComponentGraph::Edge> edges;  // of live and removed faces, ascending, each pair once
  std::vector<Vec3> middles;                // by node: centre of the face, in world coordinates [m]
  std::map<BodyId, Placement> placements;   // of the bodies when the graph was made

  bool is_removed(uint32_t node) const { return node >= live; }
  // Links of all nodes, and those between live nodes.
  GraphLinks links() const { return GraphLinks(nodes.size(), edges); }
  GraphLinks live_links() const;
};

// Returns the graph of the bodies from which faces were removed, or of all bodies if none were. A removed
// face is linked with its neighbours at its removal; if one was split since, with the part that kept its
// slot. Bodies that no longer exist are omitted. O(n).
CutGraph cut_graph(const World& world, const CutFaces& removed);

// Returns the graph of the live faces of one piece. Precondition: its body exists. O(size of the body).
CutGraph piece_graph(const World& world, const PieceId& piece);

// The traversal that determines whether a stroke has separated anything.
struct CutTraversal {
  Traversal traversal;  // of the live nodes
  // By live node: 0 if the traversal reaches it, else the number of its connected set, from 1 on; kNone if it
  // was not connected with the start before the stroke either.
  static constexpr uint32_t kNone = 0xffffffffu;
  std::vector<uint32_t> set;
  size_t total = 0;  // nodes connected with the start before the stroke, i.e. of all sets
  size_t sets = 0;

  size_t reached() const { return traversal.reached(); }
  bool separated() const { return reached() < total; }
};

// Traverses the live faces from a node. Unlike in the paper, the total is not the number of all faces: parts
// that were never connected with the start, such as the wheels of a car, are not separated by a cut.
// Precondition: start < graph.live. O(n).
CutTraversal traverse_cut(const CutGraph& graph, uint32_t start);

// Returns a start for traverse_cut: the lowest node adjacent to a removed face in the component with most
// removed faces; the lowest node if no face was removed, nullopt if no face is live.
std::optional<uint32_t> start_next_to_cut(const CutGraph& graph);

// A loop of removed faces closed by one of the removals (see CutLoops), as a polyline along their edges.
struct LoopPath {
  BodyId body;               // from which the faces were removed
  size_t removal = 0;        // the removal that closed it, counted from 1 in the order of CutGraph::nodes
  std::vector<Vec3> points;  // in world coordinates [m]
  bool runs_around = true;   // else it runs from border to border, closed by the border
};

// Returns the loops that a stroke closed, in the order of its removals, each by a shortest path, in edges,
// through the faces removed before. Faces are matched by the positions of their corners, and split edges by
// those of their midpoints. A loop is omitted if no path is found, as where it runs over a border that the
// stroke only meets in single vertices, or if its body no longer exists. O(n log n) in the removed faces,
// plus for each loop linear time in the faces removed before; the search stops after `max_visits` vertices.
std::vector<LoopPath> loop_paths(const World& world, const CutFaces& removed, size_t max_visits = 20'000'000);

}  // namespace kerf
