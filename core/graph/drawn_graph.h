#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "core/base/geometry.h"
#include "core/graph/component_graph.h"

namespace kerf {

// Merges linked nodes of one kind until at most `most` clusters are left, the smallest first, so that their
// sizes stay similar; fewer than `most` nodes are not merged. Nodes without a link stay separate: the result
// has at least one cluster for each connected set of nodes of one kind, even if these exceed `most`. The
// method is the coarsening of G. Karypis, V. Kumar: A fast and high quality multilevel scheme for
// partitioning irregular graphs (1998), with cluster sizes in place of edge weights.
//
// Returns the cluster of each node; a cluster is a connected set of nodes of one kind, and they are numbered
// in the order of their lowest nodes. `kind` has one value for each node. Precondition: kind.size() ==
// links.nodes(). O(n log n) in nodes and links.
std::vector<uint32_t> cluster_nodes(const GraphLinks& links, std::span<const uint32_t> kind, size_t most);

// The displayed graph of a cut: at most kMost nodes, each a face or a cluster of linked faces of one set.
struct DrawnGraph {
  static constexpr uint32_t kNone = CutTraversal::kNone;
  static constexpr size_t kMost = 2000;

  struct Node {
    uint32_t lowest = 0;  // its lowest node of the CutGraph
    GraphNode face;       // that node
    uint32_t faces = 0;
    bool removed = false;
    uint32_t removed_at = kNone;  // of removed faces: the number of removals before the first of them
    uint32_t set = kNone;         // of CutTraversal; kNone for removed faces
    uint32_t marked_at = kNone;   // rank of the first of its faces that the traversal marks
    Vec3 middle{0};               // mean of the centres of its faces, in world coordinates [m]
  };
  std::vector<Node> nodes;                  // in the order of `lowest`
  std::vector<ComponentGraph::Edge> edges;  // ascending, each pair once
  std::vector<uint32_t> of;                 // by node of the CutGraph: the drawn node; kNone: not drawn
  size_t reached = 0;                       // number of faces that the traversal reaches
  size_t marked = kNone;                    // number of the traversal's first faces drawn as marked
  size_t removals = kNone;                  // number of the first removals drawn as done
  std::vector<LoopPath> loops;              // closed by the removals, in order
  std::map<BodyId, Placement> placements;   // of the bodies when the graph was made

  // Returns the current world position (m) of a point on a body that was at `point` when the graph was made;
  // unchanged if the body no longer exists.
  Vec3 moved_with(BodyId body, const Vec3& point, const World& world) const;

  // State of a node after the first `marked` faces of the traversal.
  enum class State {
    kRemoved,
    kMarked,    // reached
    kUnmarked,  // not yet reached or removed, or never connected with the start
    kApart,     // not reached by the finished traversal: separated
  };
  State state(const Node& node) const;
  // Returns true if an edge leads to a face that is removed by then.
  bool is_cut(const ComponentGraph::Edge& edge) const;
};

enum class GraphScope {
  kAroundCut,  // removed faces and about as many around them, or kMost; all faces without removals
  kWhole,
};

// Selects the nodes to draw. More than kMost faces are merged into half as many clusters (see cluster_nodes),
// of which at most a fifth are removed faces and, if there are enough, two fifths are adjacent to them. The
// clusters with the nodes of `opened` are then divided, in this order, while there is room. Of more
// unconnected parts than kMost the largest are drawn. O(n log n) in the faces of the scope, plus linear time
// in the graph.
DrawnGraph draw_graph(const CutGraph& graph, const CutTraversal& traversal, GraphScope scope,
                      std::span<const uint32_t> opened = {});

// Positions in a plane, one for each node of a drawn graph, scaled so that the larger side of their bounding
// box extends from -1 to 1 and the smaller one is centred.
using GraphLayout = std::vector<Vec2>;

// Projects the positions of the nodes onto the plane in which they extend most (principal components: K.
// Pearson: On lines and planes of closest fit to systems of points in space, 1901). O(n).
GraphLayout lay_out_by_position(const DrawnGraph& graph);

// Unrolls the nodes along the cut if the removed faces run around: as if the nodes lay on a ring around the
// middle of the removed faces, opened at its widest gap. The horizontal axis is the path around, the vertical
// axis the distance from the cut, with one side above and the other below, stretched to a height of at least
// two fifths of the width. Returns nullopt if the removed faces leave a gap of a quarter turn or run through
// the middle: the layout by position shows such a cut as a whole. O(n log n).
std::optional<GraphLayout> lay_out_unrolled(const DrawnGraph& graph);

// Lays out the nodes with links as springs and repulsion between nodes (T. M. J. Fruchterman, E. M. Reingold:
// Graph drawing by force-directed placement, 1991; nodes farther apart than two spring lengths do not repel).
// Starts from the layout by position and runs a fixed number of iterations, so that the result is a function
// of the graph. O(iterations * (nodes + links)) if the nodes spread evenly; at most quadratic in the nodes.
GraphLayout lay_out_by_force(const DrawnGraph& graph);

}  // namespace kerf
