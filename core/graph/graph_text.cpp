#include "core/graph/graph_text.h"

#include <map>
#include <optional>
#include <string>

#include "core/base/json.h"

namespace kerf {

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

}  // namespace kerf
