#include "core/graph/component_graph.h"
#include "core/base/json.h"

#include <gtest/gtest.h>

#include <map>
#include <set>
#include <sstream>

#include "core/edit/separation.h"
#include "tests/support/made_meshes.h"
#include "tests/support/runs.h"
#include "tests/support/strokes.h"

namespace kerf::test {
namespace {

using Point = std::array<double, 3>;
using Segment = std::pair<Point, Point>;

Segment segment(const Vec3& a, const Vec3& b) {
  return std::minmax(Point{a.x, a.y, a.z}, Point{b.x, b.y, b.z});
}

// The pairs of faces with a common edge, from positions alone.
std::set<std::pair<uint32_t, uint32_t>> edges_by_position(const Mesh& mesh) {
  std::map<Segment, std::vector<uint32_t>> faces_on;
  for (uint32_t f = 0; f < mesh.face_slots(); ++f) {
    if (!mesh.is_live(FaceId(f))) continue;
    const Triangle t = mesh.triangle(FaceId(f));
    for (size_t i = 0; i < 3; ++i) faces_on[segment(t[i], t[(i + 1) % 3])].push_back(f);
  }
  std::set<std::pair<uint32_t, uint32_t>> pairs;
  for (const auto& [at, faces] : faces_on) {
    for (const uint32_t a : faces) {
      for (const uint32_t b : faces) {
        if (a < b) pairs.emplace(a, b);
      }
    }
  }
  return pairs;
}

void expect_graph_by_position(const ComponentGraph& graph, const Body& body) {
  std::vector<uint32_t> live;
  for (uint32_t f = 0; f < body.mesh.face_slots(); ++f) {
    if (body.mesh.is_live(FaceId(f))) live.push_back(f);
  }
  ASSERT_EQ(graph.nodes.size(), live.size());
  for (size_t i = 0; i < live.size(); ++i) {
    ASSERT_EQ(graph.nodes[i].face, FaceId(live[i]));
    ASSERT_EQ(graph.nodes[i].piece, body.mesh.data(FaceId(live[i])).piece);
  }
  std::vector<std::pair<uint32_t, uint32_t>> edges;
  for (const auto& [a, b] : graph.edges) {
    ASSERT_LT(a, b);
    ASSERT_LT(b, graph.nodes.size());
    edges.emplace_back(graph.nodes[a].face.index, graph.nodes[b].face.index);
  }
  const auto expected = edges_by_position(body.mesh);
  EXPECT_TRUE(std::equal(edges.begin(), edges.end(), expected.begin(), expected.end()))
      << edges.size() << " edges, by position " << expected.size();
}

TEST(ComponentGraph, has_the_edges_of_equal_positions_after_random_strokes) {
  for (const auto& [name, soup] : mesh_classes()) {
    for (uint64_t seed = 1; seed <= runs(8); ++seed) {
      SCOPED_TRACE(name + ", seed " + std::to_string(seed));
      World world = cut_at_random(soup, seed);
      expect_graph_by_position(component_graph(world), only_body(world));
      if (HasFatalFailure()) return;
    }
  }
}

TEST(ComponentGraph, connects_all_pairs_of_faces_on_an_edge) {
  for (int sheets = 1; sheets <= 6; ++sheets) {
    SCOPED_TRACE(sheets);
    World world = world_of(book(sheets));
    expect_graph_by_position(component_graph(world), only_body(world));
  }
}

TEST(ComponentGraph, connects_two_faces_with_two_common_edges_once) {
  const World world = world_of(pillow());
  EXPECT_EQ(component_graph(world).edges, (std::vector<ComponentGraph::Edge>{{0, 1}}));
}

TEST(ComponentGraph, of_one_piece_is_a_subgraph_of_the_whole) {
  World world = cut_at_random(grid(12, 2), 3);
  world.add(make_body("beside", build(sphere(6, 8, 0.5))));
  const ComponentGraph whole = component_graph(world);
  for (const BodyId id : world.ids()) {
    for (uint32_t label = 0; label < world.body(id).pieces.size(); ++label) {
      const PieceId piece{id, label};
      const ComponentGraph part = component_graph(world, {&piece, 1});
      std::vector<GraphNode> nodes;
      std::vector<uint32_t> number(whole.nodes.size(), Traversal::kNone);
      for (size_t i = 0; i < whole.nodes.size(); ++i) {
        if (whole.nodes[i].body != id || whole.nodes[i].piece != label) continue;
        number[i] = static_cast<uint32_t>(nodes.size());
        nodes.push_back(whole.nodes[i]);
      }
      std::vector<ComponentGraph::Edge> edges;
      for (const auto& [a, b] : whole.edges) {
        if (number[a] != Traversal::kNone && number[b] != Traversal::kNone)
          edges.push_back({number[a], number[b]});
      }
      EXPECT_EQ(part.nodes, nodes);
      EXPECT_EQ(part.edges, edges);
    }
  }
}

TEST(ComponentGraph, gives_unique_indices_to_faces_and_pieces_of_several_bodies) {
  World world = cut_at_random(grid(12, 2), 3);
  world.add(make_body("a \"quoted\" name", build(sphere(6, 8, 0.5))));
  const ComponentGraph graph = component_graph(world);
  std::ostringstream text;
  write_graph_json(graph, piece_nodes(world), world, text);
  const auto json = nlohmann::json::parse(text.str());
  std::set<size_t> faces;
  std::map<size_t, std::set<size_t>> bodies_of_piece;
  for (size_t i = 0; i < graph.nodes.size(); ++i) {
    const auto& node = json["nodes"][i];
    const auto& body = json["bodies"][node["body"].get<size_t>()];
    EXPECT_EQ(node["face"].get<size_t>() - body["first_face"].get<size_t>(), graph.nodes[i].face.index);
    EXPECT_EQ(node["piece"].get<size_t>() - body["first_piece"].get<size_t>(), graph.nodes[i].piece);
    EXPECT_TRUE(faces.insert(node["face"].get<size_t>()).second);
    bodies_of_piece[node["piece"]].insert(node["body"].get<size_t>());
  }
  EXPECT_EQ(json["nodes"].size(), graph.nodes.size());
  EXPECT_EQ(json["edges"].get<std::vector<ComponentGraph::Edge>>(), graph.edges);
  EXPECT_EQ(json["bodies"][1]["name"], "a \"quoted\" name");
  for (const auto& [piece, bodies] : bodies_of_piece) EXPECT_EQ(bodies.size(), 1u) << "piece " << piece;
  std::map<size_t, std::set<size_t>> listed;
  for (const auto& piece : json["pieces"]) listed[piece["piece"]].insert(piece["body"].get<size_t>());
  EXPECT_EQ(listed, bodies_of_piece);
}

TEST(ComponentGraph, lists_the_origin_and_support_of_each_piece) {
  const World world = world_of(both(plate(1), moved(plate(1), {3, 0, 0}, 1)));
  std::vector<PieceNode> pieces = piece_nodes(world);
  PieceNode piece = pieces[0];
  piece.came_off = PieceId{{7, 0}, 2};
  piece.step = 4;
  pieces.push_back(piece);
  std::ostringstream text;
  write_graph_json(component_graph(world), pieces, world, text);
  const auto json = nlohmann::json::parse(text.str())["pieces"];
  const nlohmann::json first{{"piece", 0},          {"name", world.body(world.ids()[0]).name_of(0)},
                             {"body", 0},           {"faces", 4},
                             {"came_off", nullptr}, {"step", nullptr},
                             {"held_by", "body"},   {"parts", 2}};
  EXPECT_EQ(json[0], first);
  EXPECT_EQ(json[1]["came_off"], nullptr) << "its body does not exist any more";
  EXPECT_EQ(json[1]["step"], 5);
}

TEST(ComponentGraph, exports_a_graphviz_line_per_node_edge_and_piece) {
  World world;
  world.add(make_body("sheet", build(plate(1))));
  std::vector<PieceNode> pieces = piece_nodes(world);
  std::ostringstream text;
  write_graph_dot(component_graph(world), pieces, world, text);
  const std::string faces =
      "graph components {\n  node [shape=circle, style=filled, colorscheme=set312];\n"
      "  0 [fillcolor=1];\n  1 [fillcolor=1];\n  0 -- 1;\n"
      "  subgraph pieces {\n    node [shape=box];\n"
      "    piece0 [fillcolor=1, label=\"sheet\\nheld by itself\"];\n";
  EXPECT_EQ(text.str(), faces + "  }\n}\n");
  pieces.front().came_off = pieces.front().piece;
  text.str("");
  write_graph_dot(component_graph(world), pieces, world, text);
  EXPECT_EQ(text.str(), faces + "    piece0 -- piece0 [dir=forward, label=\"step 1\"];\n  }\n}\n");
}

}  // namespace
}  // namespace kerf::test
