#include "core/graph/component_graph.h"

#include <algorithm>

#include "core/base/assert.h"

namespace kerf {

namespace {

// Appends the faces of a body for which `wanted` is true, and their edges.
template <typename Wanted>
void add_body(ComponentGraph& graph, BodyId id, const Mesh& mesh, const Wanted& wanted) {
  std::vector<uint32_t> node_of(mesh.face_slots(), kNoIndex);
  const size_t first = graph.nodes.size();
  for (uint32_t f = 0; f < mesh.face_slots(); ++f) {
    if (!mesh.is_live(FaceId(f)) || !wanted(mesh.data(FaceId(f)).piece)) continue;
    node_of[f] = static_cast<uint32_t>(graph.nodes.size());
    graph.nodes.push_back({id, FaceId(f), mesh.data(FaceId(f)).piece});
  }
  std::vector<FaceId> neighbours;
  for (size_t node = first; node < graph.nodes.size(); ++node) {
    const FaceId f = graph.nodes[node].face;
    neighbours.clear();
    mesh.append_neighbours(f, neighbours);
    std::sort(neighbours.begin(), neighbours.end());
    const auto end = std::unique(neighbours.begin(), neighbours.end());
    for (auto n = std::upper_bound(neighbours.begin(), end, f); n != end; ++n) {
      const uint32_t other = node_of[n->index];
      if (other != kNoIndex) graph.edges.push_back({static_cast<uint32_t>(node), other});
    }
  }
}

}  // namespace

ComponentGraph component_graph(const World& world) {
  ComponentGraph graph;
  graph.nodes.reserve(world.live_faces());
  for (const BodyId id : world.ids()) add_body(graph, id, world.body(id).mesh, [](uint32_t) { return true; });
  return graph;
}

ComponentGraph component_graph(const World& world, std::span<const PieceId> pieces) {
  std::vector<PieceId> sorted(pieces.begin(), pieces.end());
  std::sort(sorted.begin(), sorted.end());
  ComponentGraph graph;
  for (auto at = sorted.begin(); at != sorted.end();) {
    const BodyId id = at->body;
    KERF_ASSERT(world.contains(id));
    const auto end = std::find_if(at, sorted.end(), [&](const PieceId& p) { return p.body != id; });
    const auto wanted = [&](uint32_t label) { return std::binary_search(at, end, PieceId{id, label}); };
    add_body(graph, id, world.body(id).mesh, wanted);
    at = end;
  }
  return graph;
}

GraphLinks::GraphLinks(size_t nodes, std::span<const ComponentGraph::Edge> edges) {
  first_.assign(nodes + 1, 0);
  for (const auto& edge : edges) {
    for (const uint32_t end : edge) ++first_[end + 1];
  }
  for (size_t i = 0; i < nodes; ++i) first_[i + 1] += first_[i];
  linked_.resize(2 * edges.size());
  std::vector<uint32_t> next(first_.begin(), first_.end() - 1);
  for (const auto& [a, b] : edges) {
    linked_[next[a]++] = b;
    linked_[next[b]++] = a;
  }
  for (size_t i = 0; i < nodes; ++i) std::sort(linked_.begin() + first_[i], linked_.begin() + first_[i + 1]);
}

}  // namespace kerf
