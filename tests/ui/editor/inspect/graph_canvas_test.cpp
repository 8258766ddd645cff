#include "ui/editor/inspect/graph_canvas.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "core/base/random.h"

namespace kerf {
namespace {

size_t count(const std::string& text, const std::string& part) {
  size_t found = 0;
  for (size_t at = 0; (at = text.find(part, at)) != std::string::npos; at += part.size()) ++found;
  return found;
}

// Against all pairs.
TEST(GraphCanvas, nearest_distances_are_those_of_all_pairs) {
  Random random(11);
  for (int round = 0; round < 20; ++round) {
    GraphLayout places(200);
    for (Vec2& place : places) place = Vec2(random.uniform(-1, 1), random.uniform(-1, 1));
    places[7] = places[3];
    const double most = random.uniform(0.01, 0.3);
    const std::vector<double> nearest = nearest_distances(places, most);
    for (size_t i = 0; i < places.size(); ++i) {
      double expected = most;
      for (size_t k = 0; k < places.size(); ++k) {
        if (k != i) expected = std::min(expected, glm::length(places[i] - places[k]));
      }
      EXPECT_EQ(nearest[i], expected) << "seed 11, round " << round << ", place " << i;
    }
  }
}

TEST(GraphCanvas, an_exported_image_has_every_node_and_every_link) {
  DrawnGraph graph;
  graph.nodes.resize(3);
  graph.edges = {{0, 1}, {1, 2}};
  const std::string svg = graph_svg(graph, {{-1, 0}, {0, 0.5}, {1, 0}});
  EXPECT_EQ(count(svg, "<circle"), 3u);
  EXPECT_EQ(count(svg, "<line"), 2u);
  EXPECT_TRUE(svg.starts_with("<svg ") && svg.ends_with("</svg>\n"));
}

}  // namespace
}  // namespace kerf
