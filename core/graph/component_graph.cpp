#include "core/graph/component_graph.h"

#include <algorithm>
#include <array>

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

Traversal traverse(const GraphLinks& links, uint32_t start) {
  KERF_ASSERT(start < links.nodes());
  Traversal t;
  t.rank.assign(links.nodes(), Traversal::kNone);
  const auto mark = [&](uint32_t node, uint32_t from) {
    t.rank[node] = static_cast<uint32_t>(t.order.size());
    t.order.push_back(node);
    t.from.push_back(from);
  };
  mark(start, Traversal::kNone);
  for (size_t i = 0; i < t.order.size(); ++i) {
    const uint32_t node = t.order[i];
    for (const uint32_t other : links.of(node)) {
      if (t.rank[other] == Traversal::kNone) mark(other, node);
    }
  }
  return t;
}

GraphComponents find_components(const GraphLinks& links) {
  GraphComponents found;
  found.of.assign(links.nodes(), kNoIndex);
  std::vector<uint32_t> queue;
  for (uint32_t start = 0; start < links.nodes(); ++start) {
    if (found.of[start] != kNoIndex) continue;
    const auto component = static_cast<uint32_t>(found.size.size());
    queue.assign(1, start);
    found.of[start] = component;
    for (size_t i = 0; i < queue.size(); ++i) {
      for (const uint32_t other : links.of(queue[i])) {
        if (found.of[other] != kNoIndex) continue;
        found.of[other] = component;
        queue.push_back(other);
      }
    }
    found.size.push_back(static_cast<uint32_t>(queue.size()));
  }
  return found;
}

namespace {

// Every piece but the first is connected; the first has counts of its components.
size_t parts_of(const Body& body, uint32_t label) {
  if (label != 0 || body.components.left.empty()) return 1;
  size_t parts = 0;
  for (uint32_t i = 0; i < body.components.left.size(); ++i) parts += body.components.left[i].faces > 0;
  return parts;
}

Holder holder_of(const Body& body, const PieceNode& node) {
  const bool first = node.piece.label == 0;
  if (body.pinned && (first || node.beside == 0)) return Holder::kPin;
  if (!first) return Holder::kNothing;
  return node.parts > 1 ? Holder::kBody : Holder::kItself;
}

}  // namespace

const char* name_of(Holder holder) {
  constexpr std::array kNames{"nothing", "itself", "body", "pin"};
  return kNames.at(static_cast<size_t>(holder));
}

std::vector<PieceNode> piece_nodes(const World& world) {
  std::vector<PieceNode> all;
  for (const BodyId id : world.ids()) {
    const Body& body = world.body(id);
    const size_t first = all.size();
    for (uint32_t label = 0; label < body.pieces.size(); ++label) {
      if (body.pieces[label].faces == 0) continue;
      PieceNode node;
      node.piece = {id, label};
      node.parts = parts_of(body, label);
      all.push_back(node);
    }
    for (size_t i = first; i < all.size(); ++i) {
      all[i].beside = all.size() - first - 1;
      all[i].held_by = holder_of(body, all[i]);
    }
  }
  return all;
}

}  // namespace kerf
