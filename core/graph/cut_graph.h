#pragma once

#include <map>
#include <optional>
#include <vector>

#include "core/base/geometry.h"
#include "core/graph/component_graph.h"
#include "core/world/world.h"
#include "core/world/world_delta.h"

namespace kerf {

// The component graph of bodies together with the faces that a stroke removed from them.
struct CutGraph {
  std::vector<GraphNode> nodes;             // live faces, then the removed ones in the order of removal
  uint32_t live = 0;                        // the number of live faces
  std::vector<ComponentGraph::Edge> edges;  // of live and removed faces, ascending, each pair once
  std::vector<Vec3> middles;                // by node: centre of the face, m, in the world
  std::map<BodyId, Placement> placements;   // of the bodies, when the graph was made

  bool is_removed(uint32_t node) const { return node >= live; }
  // The links of all nodes, and those between live nodes.
  GraphLinks links() const { return GraphLinks(nodes.size(), edges); }
  GraphLinks live_links() const;
};

// The graph of the bodies from which faces were removed, or of all bodies if none were. A removed face is
// linked with the faces that were its neighbours when it was removed; of one that was split since, with the
// part that kept its slot. Bodies that no longer exist are left out. Linear time.
CutGraph cut_graph(const World& world, const CutFaces& removed);

// The graph of the live faces of one piece. Precondition: its body exists. Linear in the size of the body.
CutGraph piece_graph(const World& world, const PieceId& piece);

// The traversal that tells whether a stroke has separated anything.
struct CutTraversal {
  Traversal traversal;  // of the live nodes
  // By live node: 0 if the traversal reaches it, else from 1 on the number of the connected set that it
  // belongs to; kNone if it did not hang together with the start before the stroke either.
  static constexpr uint32_t kNone = 0xffffffffu;
  std::vector<uint32_t> set;
  size_t total = 0;  // nodes that hung together with the start before the stroke: those of all sets
  size_t sets = 0;

  size_t reached() const { return traversal.reached(); }
  bool separated() const { return reached() < total; }
};

// Traverses the live faces from a node. Unlike in the paper, the total is not the number of all faces: what
// never hung together with the start, such as the wheels of a car, is not separated from it by a cut.
// Precondition: start < graph.live. Linear time.
CutTraversal traverse_cut(const CutGraph& graph, uint32_t start);

// A start for traverse_cut: of the nodes that hang together with most of the removed faces, the lowest one
// that was beside a removed face; without removed faces the lowest node. Nothing if no face is live.
std::optional<uint32_t> start_beside_cut(const CutGraph& graph);

// A loop of removed faces that the removal of one of them closed (see CutLoops), as a line on the surface
// along their edges.
struct LoopPath {
  BodyId body;               // from which the faces were removed
  size_t removal = 0;        // the one that closed it: of all removals in their order, counted from 1
  std::vector<Vec3> points;  // m, in the world
  bool runs_around = true;   // else it goes from border to border, and the border closes it
};

// The loops that a stroke closed, in the order of its removals, each by a shortest way, in edges, through the
// faces that were removed before. Faces are matched by the positions of their corners, and an edge that was
// split by those of its midpoints. A loop whose way cannot be found so is left out, as where it runs over a
// border that the whole stroke meets in single vertices alone. Bodies that no longer exist are left out. O(n
// log n) in the removed faces, plus for each loop linear time in the faces that were removed before; the
// search ends after `most_visits` vertices.
std::vector<LoopPath> loop_paths(const World& world, const CutFaces& removed,
                                 size_t most_visits = 20'000'000);

}  // namespace kerf
