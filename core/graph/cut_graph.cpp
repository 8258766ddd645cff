#include "core/graph/cut_graph.h"

#include <algorithm>
#include <array>

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

std::optional<uint32_t> start_next_to_cut(const CutGraph& graph) {
  if (graph.live == 0) return std::nullopt;
  const GraphLinks links = graph.links();
  const GraphComponents whole = find_components(links);
  std::vector<size_t> removed(whole.size.size(), 0);
  for (uint32_t node = graph.live; node < graph.nodes.size(); ++node) ++removed[whole.of[node]];
  std::optional<uint32_t> best;
  for (uint32_t node = 0; node < graph.live; ++node) {
    const auto linked = links.of(node);
    if (linked.empty() || !graph.is_removed(linked.back())) continue;  // ascending: removed nodes are last
    if (!best || removed[whole.of[node]] > removed[whole.of[*best]]) best = node;
  }
  return best.value_or(0);
}

namespace {

// The edges of the faces of one body removed so far. All borders of the mesh are one additional vertex.
class RemovedEdges {
 public:
  explicit RemovedEdges(const std::vector<CutFace>& faces) {
    for (const CutFace& f : faces) places_.insert(places_.end(), f.corners.begin(), f.corners.end());
    std::sort(places_.begin(), places_.end(), lexicographic_less);
    places_.erase(std::unique(places_.begin(), places_.end()), places_.end());
    linked_.resize(places_.size() + 1);
    reached_from_.resize(linked_.size());
    seen_in_.assign(linked_.size(), 0);
  }

  uint32_t border() const { return static_cast<uint32_t>(places_.size()); }
  const Vec3& place(uint32_t vertex) const { return places_[vertex]; }

  uint32_t vertex_at(const Vec3& p) const {
    const auto found = std::lower_bound(places_.begin(), places_.end(), p, lexicographic_less);
    return found != places_.end() && *found == p ? static_cast<uint32_t>(found - places_.begin()) : kNoIndex;
  }

  void clear() {
    for (std::vector<uint32_t>& linked : linked_) linked.clear();
  }

  bool has(uint32_t a, uint32_t b) const {
    return std::find(linked_[a].begin(), linked_[a].end(), b) != linked_[a].end();
  }

  void link(uint32_t a, uint32_t b) {
    if (has(a, b)) return;
    linked_[a].push_back(b);
    linked_[b].push_back(a);
  }

  // Links the ends of an edge, and of the halves that it was split into.
  void add(uint32_t a, uint32_t b) {
    link(a, b);
    const uint32_t middle = vertex_at(0.5 * places_[a] + 0.5 * places_[b]);
    if (middle == kNoIndex || middle == a || middle == b) return;
    add(a, middle);
    add(middle, b);
  }

  // Returns the vertices of a shortest path with its ends; empty if there is none or the visits are used up.
  std::vector<uint32_t> way(uint32_t from, uint32_t to, size_t& visits) {
    ++search_;
    std::vector<uint32_t> queue{from};
    seen_in_[from] = search_;
    reached_from_[from] = kNoIndex;
    for (size_t i = 0; i < queue.size() && seen_in_[to] != search_; ++i) {
      if (visits == 0) return {};
      --visits;
      for (const uint32_t next : linked_[queue[i]]) {
        if (seen_in_[next] == search_) continue;
        seen_in_[next] = search_;
        reached_from_[next] = queue[i];
        queue.push_back(next);
      }
    }
    if (seen_in_[to] != search_) return {};
    std::vector<uint32_t> vertices;
    for (uint32_t v = to; v != kNoIndex; v = reached_from_[v]) vertices.push_back(v);
    return vertices;
  }

 private:
  std::vector<Vec3> places_;                   // by vertex, ascending
  std::vector<std::vector<uint32_t>> linked_;  // by vertex
  std::vector<uint32_t> reached_from_, seen_in_;
  uint32_t search_ = 0;
};

class LoopFinder {
 public:
  LoopFinder(BodyId id, const Body& body, const std::vector<CutFace>& faces)
      : id_(id), body_(body), faces_(faces), edges_(faces), cut_of_(body.mesh.face_slots(), kNoIndex) {
    for (uint32_t i = 0; i < faces.size(); ++i) {
      if (faces[i].face.index < cut_of_.size()) cut_of_[faces[i].face.index] = i;
    }
  }

  // Adds the faces in order, the first as the removal after `before`.
  void find(size_t before, size_t& visits, std::vector<LoopPath>& out) {
    const std::vector<std::array<bool, 3>> open_of = find_open_edges();
    for (size_t k = 0; k < faces_.size(); ++k) {
      const CutFace& f = faces_[k];
      const std::array<bool, 3>& open = open_of[k];
      const Corners c = corners_of(f);
      ++before;
      for (const uint32_t corner : c) {
        if (on_border_[corner]) edges_.link(corner, edges_.border());
      }
      std::vector<uint32_t> shortest;
      for (size_t i = 0; f.closed_loop && i < 3; ++i) {
        if (!open[i]) continue;
        std::vector<uint32_t> way = edges_.way(c[i], c[(i + 1) % 3], visits);
        if (!way.empty() && (shortest.empty() || way.size() < shortest.size())) shortest = std::move(way);
      }
      if (!shortest.empty()) out.push_back(path_of(std::move(shortest), before));
      for (size_t i = 0; i < 3; ++i) edges_.add(c[i], c[(i + 1) % 3]);
    }
  }

 private:
  using Corners = std::array<uint32_t, 3>;

  Corners corners_of(const CutFace& f) const {
    return {edges_.vertex_at(f.corners[0]), edges_.vertex_at(f.corners[1]), edges_.vertex_at(f.corners[2])};
  }

  // Returns true if a neighbour live at the removal has both ends of an edge as corners, as far as is known.
  bool is_beside(FaceId neighbour, const Vec3& a, const Vec3& b) const {
    const uint32_t cut = neighbour.index < cut_of_.size() ? cut_of_[neighbour.index] : kNoIndex;
    if (cut == kNoIndex && !body_.mesh.is_live(neighbour)) return false;
    const Triangle t = cut != kNoIndex ? faces_[cut].corners : body_.mesh.triangle(neighbour);
    return std::find(t.begin(), t.end(), a) != t.end() && std::find(t.begin(), t.end(), b) != t.end();
  }

  // Returns by face the edges with a live neighbour. Records the vertices on borders in advance, because a
  // face may meet a border in a vertex before another one meets it in an edge.
  std::vector<std::array<bool, 3>> find_open_edges() {
    on_border_.assign(edges_.border() + size_t{1}, false);
    std::vector<std::array<bool, 3>> open;
    for (const CutFace& f : faces_) {
      const Corners c = corners_of(f);
      open.push_back(open_edges(f, c));
      for (size_t i = 0; i < 3; ++i) edges_.add(c[i], c[(i + 1) % 3]);
    }
    edges_.clear();
    return open;
  }

  std::array<bool, 3> open_edges(const CutFace& f, const Corners& c) {
    std::array<bool, 3> open{}, known{};
    size_t unknown = 0, live = 0;
    for (const FaceId n : f.neighbours) live += n.valid();
    for (size_t i = 0; i < 3; ++i) {
      open[i] = !edges_.has(c[i], c[(i + 1) % 3]);
      if (!open[i]) continue;
      ++unknown;
      known[i] = std::any_of(f.neighbours.begin(), f.neighbours.end(), [&](FaceId n) {
        return n.valid() && is_beside(n, f.corners[i], f.corners[(i + 1) % 3]);
      });
    }
    for (size_t i = 0; i < 3 && unknown > live; ++i) {
      if (!open[i] || known[i]) continue;
      open[i] = false;
      --unknown;
      on_border_[c[i]] = on_border_[c[(i + 1) % 3]] = true;
    }
    return open;
  }

  LoopPath path_of(std::vector<uint32_t> way, size_t removal) const {
    LoopPath path{id_, removal, {}, true};
    const auto border = std::find(way.begin(), way.end(), edges_.border());
    if (border != way.end()) {
      path.runs_around = false;
      std::rotate(way.begin(), border, way.end());
      way.erase(way.begin());
    }
    for (const uint32_t vertex : way) path.points.push_back(body_.placement.to_world(edges_.place(vertex)));
    return path;
  }

  BodyId id_;
  const Body& body_;
  const std::vector<CutFace>& faces_;
  RemovedEdges edges_;
  std::vector<bool> on_border_;   // by vertex
  std::vector<uint32_t> cut_of_;  // by slot: index in faces_
};

}  // namespace

std::vector<LoopPath> loop_paths(const World& world, const CutFaces& removed, size_t max_visits) {
  std::vector<LoopPath> paths;
  size_t before = 0;
  for (const auto& [id, faces] : removed) {
    if (world.contains(id)) LoopFinder(id, world.body(id), faces).find(before, max_visits, paths);
    before += faces.size();
  }
  return paths;
}

}  // namespace kerf
