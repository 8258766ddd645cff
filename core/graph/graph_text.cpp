#include "core/graph/graph_text.h"

#include <map>
#include <nlohmann/json.hpp>
#include <string>

namespace kerf {

namespace {

constexpr uint32_t kColours = 12;  // of Graphviz's colour scheme set312

// The numbers of a body and of its first face and piece.
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

const char* separator(size_t i) { return i == 0 ? "\n  " : ",\n  "; }

std::string quoted(const std::string& text) {
  return nlohmann::json(text).dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
}

}  // namespace

void write_graph_json(const ComponentGraph& graph, const World& world, std::ostream& out) {
  const std::map<BodyId, FirstNumbers> first = number_bodies(world);
  out << "{\"nodes\": [";
  for (size_t i = 0; i < graph.nodes.size(); ++i) {
    const GraphNode& n = graph.nodes[i];
    const FirstNumbers& from = first.at(n.body);
    out << separator(i) << "{\"face\": " << from.face + n.face.index
        << ", \"piece\": " << from.piece + n.piece << ", \"body\": " << from.body << '}';
  }
  out << "],\n \"edges\": [";
  for (size_t i = 0; i < graph.edges.size(); ++i)
    out << separator(i) << '[' << graph.edges[i][0] << ", " << graph.edges[i][1] << ']';
  out << "],\n \"bodies\": [";
  for (const auto& [id, from] : first) {
    out << separator(from.body) << "{\"name\": " << quoted(world.body(id).own_name())
        << ", \"first_face\": " << from.face << ", \"first_piece\": " << from.piece << '}';
  }
  out << "]}\n";
}

void write_graph_dot(const ComponentGraph& graph, const World& world, std::ostream& out) {
  const std::map<BodyId, FirstNumbers> first = number_bodies(world);
  const auto number = [&](const GraphNode& n) { return first.at(n.body).face + n.face.index; };
  out << "graph components {\n  node [shape=circle, style=filled, colorscheme=set312];\n";
  for (const GraphNode& n : graph.nodes) {
    out << "  " << number(n) << " [fillcolor=" << 1 + (first.at(n.body).piece + n.piece) % kColours << "];\n";
  }
  for (const auto& [a, b] : graph.edges)
    out << "  " << number(graph.nodes[a]) << " -- " << number(graph.nodes[b]) << ";\n";
  out << "}\n";
}

}  // namespace kerf
