#pragma once

#include <map>
#include <optional>
#include <vector>

#include "core/base/geometry.h"
#include "core/graph/component_graph.h"
#include "core/world/world.h"
#include "core/world/world_delta.h"

namespace kerf {

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
  size_t removal = 0;        // the removal that closed it, of all in order, counted from 1
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
