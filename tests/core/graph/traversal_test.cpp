#include "core/graph/component_graph.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "core/edit/separation.h"
#include "tests/support/made_meshes.h"
#include "tests/support/runs.h"
#include "tests/support/strokes.h"

namespace kerf::test {
namespace {

TEST(Traversal, reaches_the_component_of_the_full_search) {
  for (const auto& [name, soup] : mesh_classes()) {
    for (uint64_t seed = 1; seed <= runs(4); ++seed) {
      SCOPED_TRACE(name + ", seed " + std::to_string(seed));
      World world = cut_at_random(soup, seed);
      const ComponentGraph graph = component_graph(world);
      if (graph.nodes.empty()) continue;
      const GraphLinks links(graph.nodes.size(), graph.edges);
      std::vector<uint32_t> label;
      const uint32_t components = label_components(only_body(world).mesh, label);
      const auto label_of = [&](uint32_t node) { return label[graph.nodes[node].face.index]; };
      Random random(seed);
      const auto start = static_cast<uint32_t>(random.below(graph.nodes.size()));
      const Traversal t = traverse(links, start);
      EXPECT_EQ(t.reached() < t.rank.size(), components > 1);
      for (uint32_t node = 0; node < t.rank.size(); ++node)
        ASSERT_EQ(t.rank[node] != Traversal::kNone, label_of(node) == label_of(start)) << "node " << node;
      EXPECT_EQ(find_components(links).size.size(), components);
    }
  }
}

TEST(Traversal, reaches_each_node_over_a_link_in_order_of_distance) {
  const World world = cut_at_random(torus(12, 16, 1, 0.4), 5);
  const ComponentGraph graph = component_graph(world);
  const GraphLinks links(graph.nodes.size(), graph.edges);
  const Traversal t = traverse(links, 0);
  std::vector<uint32_t> distance(t.rank.size(), 0);
  for (size_t i = 1; i < t.reached(); ++i) {
    const auto linked = links.of(t.order[i]);
    ASSERT_TRUE(std::find(linked.begin(), linked.end(), t.from[i]) != linked.end());
    ASSERT_LT(t.rank[t.from[i]], i);
    distance[t.order[i]] = distance[t.from[i]] + 1;
    ASSERT_GE(distance[t.order[i]], distance[t.order[i - 1]]);
  }
}

}  // namespace
}  // namespace kerf::test
