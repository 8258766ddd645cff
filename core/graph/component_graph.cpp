#include "core/graph/component_graph.h"

#include <algorithm>
#include <string>

#include "core/base/assert.h"
#include "core/base/json.h"

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

// A piece holds the connected faces that were cut off with its label, and loaded components.
size_t parts_of(const Body& body, uint32_t label) {
  const LoadedComponents& loaded = body.components;
  if (loaded.left.empty()) return 1;
  size_t parts = body.pieces[label].cut_off.faces > 0 ? 1 : 0;
  for (uint32_t i = 0; i < loaded.left.size(); ++i)
    parts += loaded.left[i].faces > 0 && loaded.home[i] == label;
  return parts;
}

Holder holder_of(const Body& body, const PieceNode& node) {
  const bool first = node.piece.label == 0;
  if (body.pinned && (first || node.beside == 0)) return Holder::kPin;
  if (!first) return Holder::kNothing;
  return node.parts > 1 ? Holder::kBody : Holder::kItself;
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
    KERF_ASSERT(edge[0] != edge[1] && std::max(edge[0], edge[1]) < nodes);
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

namespace {

constexpr uint32_t kColours = 12;  // of Graphviz's colour scheme set312

// Numbers of a body and of its first face and piece.
struct FirstNumbers {
  size_t body = 0, face = 0, piece = 0;
};

std::map<BodyId, FirstNumbers> number_bodies(const World& world) {
  std::map<BodyId, FirstNumbers> all;
  FirstNumbers next;
  for (const BodyId id : world.ids()) {
    all[id] = next;
    const Body& body = world.body(id);
    ++next.body;
    next.face += body.mesh.face_slots();
    next.piece += body.pieces.size();
  }
  return all;
}

class Numbers {
 public:
  explicit Numbers(const World& world) : first_(number_bodies(world)) {}
  const std::map<BodyId, FirstNumbers>& bodies() const { return first_; }
  size_t body(BodyId id) const { return first_.at(id).body; }
  size_t face(const GraphNode& n) const { return first_.at(n.body).face + n.face.index; }
  size_t piece(const PieceId& p) const { return first_.at(p.body).piece + p.label; }
  // Returns the row of the piece that a piece was cut off, if the body of that one still exists.
  std::optional<size_t> came_off(const PieceNode& node) const {
    if (!node.came_off || !first_.contains(node.came_off->body)) return std::nullopt;
    return piece(*node.came_off);
  }

 private:
  std::map<BodyId, FirstNumbers> first_;
};

const char* separator(size_t i) { return i == 0 ? "\n  " : ",\n  "; }

std::string quoted(const std::string& text) {
  return nlohmann::json(text).dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
}

std::string or_null(std::optional<size_t> number) { return number ? std::to_string(*number) : "null"; }

void write_piece_json(const PieceNode& node, const Numbers& numbers, const World& world, std::ostream& out) {
  const Body& body = world.body(node.piece.body);
  out << "{\"piece\": " << numbers.piece(node.piece)
      << ", \"name\": " << quoted(body.name_of(node.piece.label))
      << ", \"body\": " << numbers.body(node.piece.body)
      << ", \"faces\": " << body.pieces[node.piece.label].faces
      << ", \"came_off\": " << or_null(numbers.came_off(node))
      << ", \"step\": " << or_null(node.came_off ? std::optional(node.step + 1) : std::nullopt)
      << ", \"held_by\": \"" << name_of(node.held_by) << "\", \"parts\": " << node.parts << '}';
}

std::string holder_text(const PieceNode& node) {
  if (node.held_by == Holder::kBody) return std::to_string(node.parts) + " parts, held by one body";
  return std::string("held by ") + name_of(node.held_by);
}

void write_pieces_dot(std::span<const PieceNode> pieces, const Numbers& numbers, const World& world,
                      std::ostream& out) {
  out << "  subgraph pieces {\n    node [shape=box];\n";
  for (const PieceNode& node : pieces) {
    const size_t number = numbers.piece(node.piece);
    const std::string name = world.body(node.piece.body).name_of(node.piece.label);
    out << "    piece" << number << " [fillcolor=" << 1 + number % kColours
        << ", label=" << quoted(name + "\n" + holder_text(node)) << "];\n";
  }
  for (const PieceNode& node : pieces) {
    const std::optional<size_t> from = numbers.came_off(node);
    if (!from) continue;
    out << "    piece" << *from << " -- piece" << numbers.piece(node.piece) << " [dir=forward, label=\"step "
        << node.step + 1 << "\"];\n";
  }
  out << "  }\n";
}

}  // namespace

void write_graph_json(const ComponentGraph& graph, std::span<const PieceNode> pieces, const World& world,
                      std::ostream& out) {
  const Numbers numbers(world);
  out << "{\"nodes\": [";
  for (size_t i = 0; i < graph.nodes.size(); ++i) {
    const GraphNode& n = graph.nodes[i];
    out << separator(i) << "{\"face\": " << numbers.face(n)
        << ", \"piece\": " << numbers.piece({n.body, n.piece}) << ", \"body\": " << numbers.body(n.body)
        << '}';
  }
  out << "],\n \"edges\": [";
  for (size_t i = 0; i < graph.edges.size(); ++i)
    out << separator(i) << '[' << graph.edges[i][0] << ", " << graph.edges[i][1] << ']';
  out << "],\n \"bodies\": [";
  for (const auto& [id, from] : numbers.bodies()) {
    out << separator(from.body) << "{\"name\": " << quoted(world.body(id).own_name())
        << ", \"first_face\": " << from.face << ", \"first_piece\": " << from.piece << '}';
  }
  out << "],\n \"pieces\": [";
  for (size_t i = 0; i < pieces.size(); ++i) {
    out << separator(i);
    write_piece_json(pieces[i], numbers, world, out);
  }
  out << "]}\n";
}

void write_graph_dot(const ComponentGraph& graph, std::span<const PieceNode> pieces, const World& world,
                     std::ostream& out) {
  const Numbers numbers(world);
  out << "graph components {\n  node [shape=circle, style=filled, colorscheme=set312];\n";
  for (const GraphNode& n : graph.nodes) {
    out << "  " << numbers.face(n) << " [fillcolor=" << 1 + numbers.piece({n.body, n.piece}) % kColours
        << "];\n";
  }
  for (const auto& [a, b] : graph.edges)
    out << "  " << numbers.face(graph.nodes[a]) << " -- " << numbers.face(graph.nodes[b]) << ";\n";
  write_pieces_dot(pieces, numbers, world, out);
  out << "}\n";
}

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
    KERF_ASSERT(std::max(a, b) < linked_.size());
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

GraphLinks CutGraph::live_links() const {
  KERF_ASSERT(live <= nodes.size());
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
  KERF_ASSERT(graph.middles.size() == graph.nodes.size());
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

std::vector<LoopPath> loop_paths(const World& world, const CutFaces& removed, size_t max_visits) {
  std::vector<LoopPath> paths;
  size_t before = 0;
  for (const auto& [id, faces] : removed) {
    if (!world.contains(id)) continue;
    LoopFinder(id, world.body(id), faces).find(before, max_visits, paths);
    before += faces.size();
  }
  return paths;
}

}  // namespace kerf
