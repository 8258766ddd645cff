#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "core/base/geometry.h"
#include "core/graph/component_graph.h"
#include "core/graph/cut_graph.h"

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

// The part of the graph of a cut that is drawn: at most kMost nodes, each of them a face or a cluster of
// linked faces of one set.
struct DrawnGraph {
  static constexpr uint32_t kNone = CutTraversal::kNone;
  static constexpr size_t kMost = 2000;

  struct Node {
    uint32_t lowest = 0;  // the lowest node of the CutGraph in it
    GraphNode face;       // that node
    uint32_t faces = 0;
    bool removed = false;
    uint32_t removed_at = kNone;  // of removed faces: how many removals came before the first of them
    uint32_t set = kNone;         // of CutTraversal; kNone for removed faces
    uint32_t marked_at = kNone;   // the rank at which the traversal marks the first of its faces
    Vec3 middle{0};               // mean of the middles of its faces, m, in the world
  };
  std::vector<Node> nodes;                  // in the order of `lowest`
  std::vector<ComponentGraph::Edge> edges;  // ascending, each pair once
  std::vector<uint32_t> of;                 // by node of the CutGraph: the drawn node; kNone: not drawn
  size_t reached = 0;                       // faces that the traversal reaches
  size_t marked = kNone;                    // the first faces of the traversal that are drawn as marked
  size_t removals = kNone;                  // the first removals that are drawn as done
  std::vector<LoopPath> loops;              // that the removals closed, in their order
  std::map<BodyId, Placement> placements;   // of the bodies, when the graph was made

  // Where a point on a body is, in the world (m), that was at `point` when the graph was made: bodies move. A
  // point of a body that no longer exists stays.
  Vec3 moved_with(BodyId body, const Vec3& point, const World& world) const;

  // The state of a node for the traversal after its first `marked` faces.
  enum class State {
    kRemoved,
    kMarked,    // it was reached
    kUnmarked,  // it was not reached or removed yet, or never hung together with the start
    kApart,     // the traversal is over and has not reached it: it was separated
  };
  State state(const Node& node) const;
  // Whether an edge leads to a face that is removed by then.
  bool is_cut(const ComponentGraph::Edge& edge) const;
};

// Which faces are drawn.
enum class GraphScope {
  kAroundCut,  // removed faces and about as many around them, or kMost; all if none were removed
  kWhole,
};

// Chooses what is drawn. More than kMost faces are joined to clusters (see cluster_nodes), half as many as
// kMost; of these at most a fifth are removed faces and, where there are so many, two fifths lie beside them.
// The clusters that hold the nodes of `opened` are then divided, in this order, as long as there is
// room. Of more unconnected parts than kMost the largest are drawn. O(n log n) in the faces of the scope,
// plus linear time in the graph.
DrawnGraph draw_graph(const CutGraph& graph, const CutTraversal& traversal, GraphScope scope,
                      std::span<const uint32_t> opened = {});

// Places of nodes in a plane, one for each node of a drawn graph. The plane is scaled so that the larger side
// of their bounding box is from -1 to 1 and the smaller one is centred.
using GraphLayout = std::vector<Vec2>;

// Where the nodes are in space, projected onto a plane: that of the two directions in which the nodes extend
// most (principal components: K. Pearson: On lines and planes of closest fit to systems of points in space,
// 1901). Linear time.
GraphLayout lay_out_by_position(const DrawnGraph& graph);

// Unrolled along the cut, where the removed faces run around: as if the nodes lay on a ring around the middle
// of the removed faces, which is opened at its widest gap. From left to right is the way around, and upwards
// the distance from the cut, with one of its sides above and the other below; the height is stretched to two
// fifths of the width where it is less. Nothing where the removed faces leave a gap of a quarter turn or run
// through the middle: such a cut is seen as a whole by position. O(n log n).
std::optional<GraphLayout> lay_out_unrolled(const DrawnGraph& graph);

// As if links were springs and nodes repelled each other (T. M. J. Fruchterman, E. M. Reingold: Graph drawing
// by force-directed placement, 1991; nodes farther apart than two lengths of a spring do not repel). Starts
// from the layout by position and takes a fixed number of turns, so that the result is a function of the
// graph. O(turns * (nodes + links)) if the nodes spread evenly; at most quadratic in the nodes.
GraphLayout lay_out_by_force(const DrawnGraph& graph);

}  // namespace kerf
