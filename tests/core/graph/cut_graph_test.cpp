#include "core/graph/component_graph.h"

#include <gtest/gtest.h>

#include <map>
#include <set>

#include "core/edit/separation.h"
#include "tests/support/made_meshes.h"
#include "tests/support/runs.h"
#include "tests/support/strokes.h"

namespace kerf::test {
namespace {

// A random stroke through a body, and what it removed.
struct RandomCut {
  World world;
  CutFaces removed;
  StepResult done;
  std::vector<uint32_t> component_before;  // by loaded face
  uint32_t components_before = 0;
};

RandomCut graph_of_random_cut(const Soup& soup, uint64_t seed) {
  RandomCut cut{world_of(soup), {}, {}, {}, 0};
  cut.components_before = label_components(only_body(cut.world).mesh, cut.component_before);
  Random random(seed);
  const RandomStroke stroke = random_stroke(cut.world, random, 0.05, true);
  auto done = cut_whole(cut.world, stroke.settings, stroke.moves);
  EXPECT_TRUE(done.ok());
  if (done) cut.done = std::move(*done);
  while (!is_settled(cut.world)) cut.done.delta.append(continue_separation(cut.world, 100'000).delta);
  for (const BodyDelta& b : cut.done.delta.bodies) {
    if (!b.removed.empty()) cut.removed[b.body] = b.removed;
  }
  return cut;
}

template <typename Check>
void for_random_cuts(uint64_t seeds, const Check& check) {
  for (const auto& [name, soup] : mesh_classes()) {
    for (uint64_t seed = 1; seed <= runs(seeds); ++seed) {
      SCOPED_TRACE(name + ", seed " + std::to_string(seed));
      check(graph_of_random_cut(soup, seed));
      if (::testing::Test::HasFatalFailure()) return;
    }
  }
}

TEST(CutGraph, contains_each_removed_face_once_with_its_original_corners) {
  for_random_cuts(8, [](const RandomCut& cut) {
    std::set<std::pair<BodyId, FaceId>> slots;
    double area = 0;
    for (const auto& [id, faces] : cut.removed) {
      for (const CutFace& f : faces) {
        EXPECT_TRUE(slots.emplace(id, f.face).second);
        EXPECT_FALSE(cut.world.body(id).mesh.is_live(f.face));
        area += triangle_area(f.corners);
      }
    }
    EXPECT_EQ(slots.size(), cut.done.delta.removed_faces);
    EXPECT_NEAR(area, cut.done.delta.removed_area, 1e-9 * area);
  });
}

// Removed faces stand where they were, so what hung together before the stroke does so in the graph.
TEST(CutGraph, has_the_components_of_the_mesh_before_the_stroke) {
  for_random_cuts(8, [](const RandomCut& cut) {
    if (cut.removed.empty()) return;
    const CutGraph graph = cut_graph(cut.world, cut.removed);
    EXPECT_EQ(graph.nodes.size(), graph.live + cut.done.delta.removed_faces);
    const GraphComponents found = find_components(graph.links());
    EXPECT_EQ(found.size.size(), cut.components_before);
    const Mesh& mesh = cut.world.body(cut.world.ids()[0]).mesh;
    std::map<uint32_t, uint32_t> before_of;
    for (uint32_t node = 0; node < graph.live; ++node) {
      const uint32_t before = cut.component_before[mesh.data(graph.nodes[node].face).base.index];
      const auto known = before_of.try_emplace(found.of[node], before).first;
      ASSERT_EQ(known->second, before) << "node " << node;
    }
  });
}

TEST(CutGraph, separates_into_the_parts_of_a_full_search) {
  for_random_cuts(8, [](const RandomCut& cut) {
    const CutGraph graph = cut_graph(cut.world, cut.removed);
    const auto start = start_next_to_cut(graph);
    if (!start) return;
    const CutTraversal t = traverse_cut(graph, *start);
    const Mesh& mesh = cut.world.body(cut.world.ids()[0]).mesh;
    std::vector<uint32_t> label;
    label_components(mesh, label);
    const auto before = [&](uint32_t node) {
      return cut.component_before[mesh.data(graph.nodes[node].face).base.index];
    };
    std::set<uint32_t> parts;
    size_t total = 0;
    for (uint32_t node = 0; node < graph.live; ++node) {
      ASSERT_EQ(t.set[node] != CutTraversal::kNone, before(node) == before(*start));
      if (t.set[node] == CutTraversal::kNone) continue;
      ++total;
      parts.insert(label[graph.nodes[node].face.index]);
      ASSERT_EQ(t.set[node] == 0,
                label[graph.nodes[node].face.index] == label[graph.nodes[*start].face.index]);
    }
    EXPECT_EQ(t.total, total);
    EXPECT_EQ(t.sets, parts.size());
    EXPECT_EQ(t.separated(), parts.size() > 1);
  });
}

// By Alexander duality (see CutLoops).
TEST(CutGraph, contains_the_removed_face_that_closed_a_separating_loop) {
  size_t separated = 0;
  for (uint64_t seed = 1; seed <= runs(40); ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    const RandomCut cut = graph_of_random_cut(sphere(12, 16, 1), seed);
    bool came_apart = false, closed = false;
    for (const BodyDelta& b : cut.done.delta.bodies) came_apart |= !b.new_pieces.empty();
    for (const auto& [id, faces] : cut.removed) {
      for (const CutFace& f : faces) closed |= f.closed_loop;
    }
    EXPECT_TRUE(closed || !came_apart);
    separated += came_apart;
  }
  EXPECT_GT(separated, 0u);
}

TEST(CutGraph, starts_at_a_node_next_to_the_cut) {
  const RandomCut cut = graph_of_random_cut(grid(12, 2), 3);
  const CutGraph graph = cut_graph(cut.world, cut.removed);
  const auto start = start_next_to_cut(graph);
  ASSERT_TRUE(start);
  const GraphLinks links = graph.links();
  EXPECT_TRUE(graph.is_removed(links.of(*start).back()));
}

}  // namespace
}  // namespace kerf::test
