#pragma once

#include <span>

#include "core/graph/cut_graph.h"
#include "core/graph/loop_paths.h"

namespace kerf {

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

}  // namespace kerf
