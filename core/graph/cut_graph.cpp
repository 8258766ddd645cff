#include "core/graph/cut_graph.h"

#include <algorithm>

#include "core/base/assert.h"

namespace kerf {

namespace {

using Edges = std::vector<ComponentGraph::Edge>;

Vec3 middle_of(const Triangle& t) { return t[0] / 3.0 + t[1] / 3.0 + t[2] / 3.0; }

std::vector<PieceId> pieces_of(const World& world, const CutFaces& removed) {
  std::vector<PieceId> pieces;
  for (const BodyId id : world.ids()) {
    if (!removed.empty() && !removed.contains(id)) continue;
    for (uint32_t label = 0; label < world.body(id).pieces.size(); ++label) pieces.push_back({id, label});
  }
  return pieces;
}

CutGraph live_graph(const World& world, std::span<const PieceId> pieces) {
  ComponentGraph faces = component_graph(world, pieces);
  CutGraph graph;
  graph.live = static_cast<uint32_t>(faces.nodes.size());
  graph.nodes = std::move(faces.nodes);
  graph.edges = std::move(faces.edges);
  for (const BodyId id : world.ids()) graph.placements[id] = world.body(id).placement;
  for (const GraphNode& n : graph.nodes) {
    const Body& body = world.body(n.body);
    graph.middles.push_back(body.placement.to_world(middle_of(body.mesh.triangle(n.face))));
  }
  return graph;
}

// Adds removed faces of one body to a graph that holds its live ones.
void add_removed(CutGraph& graph, BodyId id, const Body& body, const std::vector<CutFace>& removed) {
  std::vector<uint32_t> node_of(body.mesh.face_slots(), kNoIndex);
  for (uint32_t node = 0; node < graph.live; ++node) {
    if (graph.nodes[node].body == id) node_of[graph.nodes[node].face.index] = node;
  }
  for (const CutFace& cut : removed) {
    if (cut.face.index < node_of.size()) node_of[cut.face.index] = static_cast<uint32_t>(graph.nodes.size());
    graph.nodes.push_back({id, cut.face, cut.piece});
    graph.middles.push_back(body.placement.to_world(middle_of(cut.corners)));
  }
  auto node = static_cast<uint32_t>(graph.nodes.size() - removed.size());
  for (const CutFace& cut : removed) {
    for (const FaceId n : cut.neighbours) {
      const uint32_t other = n.index < node_of.size() ? node_of[n.index] : kNoIndex;
      if (other != kNoIndex && other != node)
        graph.edges.push_back({std::min(node, other), std::max(node, other)});
    }
    ++node;
  }
}

void sort_each_once(Edges& edges) {
  std::sort(edges.begin(), edges.end());
  edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
}

}  // namespace

GraphLinks CutGraph::live_links() const {
  Edges both_live;
  std::copy_if(edges.begin(), edges.end(), std::back_inserter(both_live),
               [&](const ComponentGraph::Edge& e) { return e[1] < live; });
  return GraphLinks(live, both_live);
}

CutGraph cut_graph(const World& world, const CutFaces& removed) {
  CutGraph graph = live_graph(world, pieces_of(world, removed));
  for (const auto& [id, cut] : removed) {
    if (world.contains(id)) add_removed(graph, id, world.body(id), cut);
  }
  sort_each_once(graph.edges);
  return graph;
}

CutGraph piece_graph(const World& world, const PieceId& piece) { return live_graph(world, {&piece, 1}); }

CutTraversal traverse_cut(const CutGraph& graph, uint32_t start) {
  KERF_ASSERT(start < graph.live);
  const GraphLinks live = graph.live_links();
  CutTraversal result;
  result.traversal = traverse(live, start);
  const Traversal before = traverse(graph.links(), start);
  const GraphComponents parts = find_components(live);
  std::vector<uint32_t> number(parts.size.size(), kNoIndex);
  number[parts.of[start]] = 0;
  result.sets = 1;
  result.set.assign(graph.live, kNoIndex);
  for (uint32_t node = 0; node < graph.live; ++node) {
    if (before.rank[node] == Traversal::kNone) continue;
    uint32_t& set = number[parts.of[node]];
    if (set == kNoIndex) set = static_cast<uint32_t>(result.sets++);
    result.set[node] = set;
    ++result.total;
  }
  return result;
}

std::optional<uint32_t> start_beside_cut(const CutGraph& graph) {
  if (graph.live == 0) return std::nullopt;
  const GraphLinks links = graph.links();
  const GraphComponents whole = find_components(links);
  std::vector<size_t> removed(whole.size.size(), 0);
  for (uint32_t node = graph.live; node < graph.nodes.size(); ++node) ++removed[whole.of[node]];
  std::optional<uint32_t> best;
  for (uint32_t node = 0; node < graph.live; ++node) {
    const auto linked = links.of(node);
    if (linked.empty() || !graph.is_removed(linked.back())) continue;  // ascending: removed ones come last
    if (!best || removed[whole.of[node]] > removed[whole.of[*best]]) best = node;
  }
  return best.value_or(0);
}

}  // namespace kerf
