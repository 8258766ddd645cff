#include "core/graph/drawn_graph.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "core/edit/separation.h"
#include "tests/support/made_meshes.h"
#include "tests/support/strokes.h"

namespace kerf::test {
namespace {

// The graph of a sheet or a ball with a slot, as a view shows it.
struct Shown {
  World world;
  CutGraph graph;
  CutTraversal traversal;
};

Shown cut_across(const Soup& soup, uint64_t seed, double radius_share) {
  Shown shown{world_of(soup), {}, {}};
  Random random(seed);
  const RandomStroke stroke = random_stroke(shown.world, random, radius_share, false);
  auto done = cut_whole(shown.world, stroke.settings, stroke.moves);
  EXPECT_TRUE(done.ok());
  CutFaces removed;
  for (const BodyDelta& b : done->delta.bodies) removed[b.body] = b.removed;
  shown.graph = cut_graph(shown.world, removed);
  const auto start = start_next_to_cut(shown.graph);
  EXPECT_TRUE(start);
  shown.traversal = traverse_cut(shown.graph, start.value_or(0));
  return shown;
}

// Longer in one direction, flatter in another, and turned anyhow.
Soup stretched_and_turned(Soup soup, Random& random) {
  const auto any = [&] { return random.uniform(-1, 1); };
  const glm::dquat turn = glm::normalize(glm::dquat(any(), any(), any(), any()));
  for (Vec3& p : soup.positions) p = turn * (p * Vec3(2, 1, 0.5));
  return soup;
}

bool has_clusters(const DrawnGraph& drawn) {
  return std::ranges::any_of(drawn.nodes, [](const DrawnGraph::Node& n) { return n.faces > 1; });
}

bool is_connected(const CutGraph& graph, const std::vector<uint32_t>& nodes) {
  const std::set<uint32_t> wanted(nodes.begin(), nodes.end());
  const GraphLinks links = graph.links();
  std::set<uint32_t> seen{nodes[0]};
  std::vector<uint32_t> queue{nodes[0]};
  for (size_t i = 0; i < queue.size(); ++i) {
    for (const uint32_t other : links.of(queue[i])) {
      if (wanted.contains(other) && seen.insert(other).second) queue.push_back(other);
    }
  }
  return seen.size() == wanted.size();
}

void expect_sound(const Shown& shown, const DrawnGraph& drawn) {
  ASSERT_LE(drawn.nodes.size(), DrawnGraph::kMost);
  std::vector<std::vector<uint32_t>> members(drawn.nodes.size());
  for (uint32_t node = 0; node < drawn.of.size(); ++node) {
    if (drawn.of[node] != DrawnGraph::kNone) members[drawn.of[node]].push_back(node);
  }
  for (size_t i = 0; i < members.size(); ++i) {
    const DrawnGraph::Node& n = drawn.nodes[i];
    ASSERT_EQ(members[i].size(), n.faces);
    ASSERT_EQ(members[i][0], n.lowest);
    ASSERT_TRUE(is_connected(shown.graph, members[i])) << "node " << i;
    for (const uint32_t node : members[i]) {
      ASSERT_EQ(shown.graph.is_removed(node), n.removed);
      if (!n.removed) ASSERT_EQ(shown.traversal.set[node], n.set);
    }
  }
  for (const auto& [a, b] : drawn.edges) ASSERT_LT(a, b);
}

TEST(DrawnGraph, shows_single_faces_of_a_small_mesh) {
  const Shown shown = cut_across(grid(8, 2), 2, 0.05);
  const DrawnGraph drawn = draw_graph(shown.graph, shown.traversal, GraphScope::kWhole);
  expect_sound(shown, drawn);
  EXPECT_FALSE(has_clusters(drawn));
  EXPECT_EQ(drawn.nodes.size(), shown.graph.nodes.size());
  EXPECT_EQ(drawn.edges, shown.graph.edges);
}

TEST(DrawnGraph, merges_faces_of_a_large_mesh_into_connected_clusters_per_set) {
  for (uint64_t seed = 1; seed <= 4; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    const Shown shown = cut_across(grid(60, 2), seed, 0.02);
    const DrawnGraph drawn = draw_graph(shown.graph, shown.traversal, GraphScope::kWhole);
    expect_sound(shown, drawn);
    if (HasFatalFailure()) return;
    EXPECT_TRUE(has_clusters(drawn));
    const DrawnGraph again = draw_graph(shown.graph, shown.traversal, GraphScope::kWhole);
    EXPECT_EQ(again.of, drawn.of);
  }
}

TEST(DrawnGraph, shows_the_faces_nearest_to_a_cut) {
  const Shown shown = cut_across(grid(60, 2), 1, 0.02);
  const DrawnGraph drawn = draw_graph(shown.graph, shown.traversal, GraphScope::kAroundCut);
  expect_sound(shown, drawn);
  for (uint32_t node = shown.graph.live; node < shown.graph.nodes.size(); ++node)
    ASSERT_NE(drawn.of[node], DrawnGraph::kNone) << "every removed face is drawn";
  EXPECT_LT(static_cast<size_t>(std::count(drawn.of.begin(), drawn.of.end(), DrawnGraph::kNone)),
            shown.graph.nodes.size());
}

TEST(DrawnGraph, gives_faces_next_to_a_fine_cut_more_nodes_than_removed_ones) {
  const Shown shown = cut_across(sphere(40, 60, 1), 2, 0.02);
  const size_t removed = shown.graph.nodes.size() - shown.graph.live;
  ASSERT_GT(removed, DrawnGraph::kMost);
  const DrawnGraph drawn = draw_graph(shown.graph, shown.traversal, GraphScope::kAroundCut);
  expect_sound(shown, drawn);
  const GraphLinks links = shown.graph.links();
  std::set<uint32_t> red, beside;
  size_t faces_beside = 0;
  for (uint32_t node = 0; node < shown.graph.nodes.size(); ++node) {
    if (shown.graph.is_removed(node)) {
      red.insert(drawn.of[node]);
    } else if (!links.of(node).empty() && shown.graph.is_removed(links.of(node).back())) {
      beside.insert(drawn.of[node]);
      ++faces_beside;
    }
  }
  EXPECT_LE(red.size(), DrawnGraph::kMost / 2 / 5);
  EXPECT_GE(beside.size(), std::min(faces_beside, 2 * red.size()));
  EXPECT_GT(drawn.nodes.size(), DrawnGraph::kMost * 2 / 5);
}

TEST(DrawnGraph, shows_removals_step_by_step) {
  const Shown shown = cut_across(grid(8, 2), 2, 0.05);
  DrawnGraph drawn = draw_graph(shown.graph, shown.traversal, GraphScope::kWhole);
  const size_t removed = shown.graph.nodes.size() - shown.graph.live;
  ASSERT_GT(removed, 5u);
  for (size_t removals = 0; removals <= removed; ++removals) {
    drawn.removals = removals;
    size_t red = 0, cut = 0;
    for (const DrawnGraph::Node& n : drawn.nodes) red += drawn.state(n) == DrawnGraph::State::kRemoved;
    for (const auto& edge : drawn.edges) cut += drawn.is_cut(edge);
    EXPECT_EQ(red, removals);
    EXPECT_EQ(cut > 0, removals > 0);
  }
}

TEST(DrawnGraph, expands_a_cluster_into_its_faces) {
  const Shown shown = cut_across(grid(60, 2), 1, 0.02);
  const DrawnGraph closed = draw_graph(shown.graph, shown.traversal, GraphScope::kWhole);
  const auto cluster = std::find_if(closed.nodes.begin(), closed.nodes.end(),
                                    [](const DrawnGraph::Node& n) { return n.faces > 1; });
  ASSERT_NE(cluster, closed.nodes.end());
  const uint32_t opened = cluster->lowest;
  const DrawnGraph open = draw_graph(shown.graph, shown.traversal, GraphScope::kWhole, {&opened, 1});
  expect_sound(shown, open);
  EXPECT_EQ(open.nodes.size(), closed.nodes.size() + cluster->faces - 1);
  EXPECT_EQ(open.nodes[open.of[opened]].faces, 1u);
}

// With 1998 single faces and a sheet as one node, there is room for one node more.
TEST(DrawnGraph, expands_a_cluster_up_to_the_node_limit) {
  Soup soup = grid(3, 1);
  const auto first = static_cast<uint32_t>(soup.positions.size());
  for (uint32_t i = 0; i < DrawnGraph::kMost - 2; ++i) {
    const double x = 3.0 * i + 3;
    soup.positions.insert(soup.positions.end(), {{x, 0, 0}, {x + 1, 0, 0}, {x, 0, 1}});
    soup.triangles.push_back({first + 3 * i, first + 3 * i + 1, first + 3 * i + 2});
  }
  Shown shown{world_of(soup), {}, {}};
  shown.graph = cut_graph(shown.world, {});
  shown.traversal = traverse_cut(shown.graph, 0);
  const DrawnGraph closed = draw_graph(shown.graph, shown.traversal, GraphScope::kWhole);
  ASSERT_EQ(closed.nodes.size(), DrawnGraph::kMost - 1);
  ASSERT_EQ(closed.nodes[0].faces, 18u);
  const uint32_t sheet = 0;
  const DrawnGraph open = draw_graph(shown.graph, shown.traversal, GraphScope::kWhole, {&sheet, 1});
  expect_sound(shown, open);
  EXPECT_EQ(open.nodes.size(), DrawnGraph::kMost);
  EXPECT_LT(open.nodes[0].faces, 18u);
}

TEST(DrawnGraph, draws_the_largest_parts_if_there_are_too_many) {
  Soup soup;
  for (uint32_t i = 0; i < 2500; ++i) {
    const double x = 3.0 * i;
    soup.positions.insert(soup.positions.end(), {{x, 0, 0}, {x + 1, 0, 0}, {x, 0, 1}});
    soup.triangles.push_back({3 * i, 3 * i + 1, 3 * i + 2});
  }
  Shown shown{world_of(soup), {}, {}};
  shown.graph = cut_graph(shown.world, {});
  shown.traversal = traverse_cut(shown.graph, 0);
  const DrawnGraph drawn = draw_graph(shown.graph, shown.traversal, GraphScope::kAroundCut);
  expect_sound(shown, drawn);
  EXPECT_EQ(drawn.nodes.size(), DrawnGraph::kMost);
}

TEST(DrawnGraph, marks_nodes_during_traversal_and_reports_separation_at_the_end) {
  const Shown shown = cut_across(grid(8, 2), 2, 0.05);
  DrawnGraph drawn = draw_graph(shown.graph, shown.traversal, GraphScope::kWhole);
  using State = DrawnGraph::State;
  for (size_t marked = 0; marked <= drawn.reached; ++marked) {
    drawn.marked = marked;
    size_t seen = 0;
    for (const DrawnGraph::Node& n : drawn.nodes) {
      seen += drawn.state(n) == State::kMarked;
      if (marked < drawn.reached) EXPECT_NE(drawn.state(n), State::kApart);
    }
    EXPECT_EQ(seen, marked);
  }
  size_t apart = 0;
  for (const DrawnGraph::Node& n : drawn.nodes) apart += drawn.state(n) == State::kApart;
  EXPECT_EQ(apart, shown.traversal.total - shown.traversal.reached());
}

TEST(GraphLayout, by_position_is_a_flat_sheet_to_scale) {
  const Shown shown = cut_across(grid(10, 2), 2, 0.05);
  const DrawnGraph drawn = draw_graph(shown.graph, shown.traversal, GraphScope::kWhole);
  const GraphLayout places = lay_out_by_position(drawn);
  ASSERT_EQ(places.size(), drawn.nodes.size());
  const auto apart = [&](size_t i, size_t k) {
    return glm::length(drawn.nodes[i].middle - drawn.nodes[k].middle);
  };
  const double scale = glm::length(places[1] - places[0]) / apart(1, 0);
  for (size_t i = 2; i < places.size(); ++i)
    ASSERT_NEAR(glm::length(places[i] - places[0]), scale * apart(i, 0), 1e-9) << "node " << i;
}

TEST(GraphLayout, by_position_is_widest_horizontally_and_not_skewed) {
  for (uint64_t seed = 1; seed <= 5; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Random random(seed);
    Shown whole{world_of(stretched_and_turned(torus(14, 10, 1, 0.3), random)), {}, {}};
    whole.graph = cut_graph(whole.world, {});
    whole.traversal = traverse_cut(whole.graph, 0);
    const GraphLayout places =
        lay_out_by_position(draw_graph(whole.graph, whole.traversal, GraphScope::kWhole));
    Vec2 mean(0);
    for (const Vec2& p : places) mean += p / static_cast<double>(places.size());
    double xx = 0, xy = 0, yy = 0;
    for (const Vec2& p : places) {
      const Vec2 d = p - mean;
      xx += d.x * d.x;
      xy += d.x * d.y;
      yy += d.y * d.y;
    }
    EXPECT_GE(xx, yy);
    EXPECT_NEAR(xy, 0, 1e-9 * xx);
  }
}

TEST(GraphLayout, unrolls_a_cut_around_a_ball_with_its_sides_above_and_below) {
  Shown shown{world_of(sphere(24, 32, 1)), {}, {}};
  const Vec3 forward(0, 0, -1);
  CutSettings settings;
  settings.laser.radius = settings.resolution.target_edge = 0.06;
  const std::vector<BeamMove> moves = subdivide({{{-2, 0.03, 3}, forward}, {{2, 0.03, 3}, forward}}, 0.06, 4);
  const auto done = cut_whole(shown.world, settings, moves);
  ASSERT_TRUE(done.ok());
  CutFaces removed;
  for (const BodyDelta& b : done->delta.bodies) removed[b.body] = b.removed;
  shown.graph = cut_graph(shown.world, removed);
  shown.traversal = traverse_cut(shown.graph, start_next_to_cut(shown.graph).value());
  ASSERT_TRUE(shown.traversal.separated());
  const DrawnGraph drawn = draw_graph(shown.graph, shown.traversal, GraphScope::kWhole);
  const std::optional<GraphLayout> places = lay_out_unrolled(drawn);
  ASSERT_TRUE(places);
  double side = 0, widest = 0;
  for (size_t i = 0; i < drawn.nodes.size(); ++i) {
    if (drawn.nodes[i].removed) continue;
    const bool first = drawn.nodes[i].set == 0;
    if (side == 0) side = first ? (*places)[i].y : -(*places)[i].y;
    ASSERT_GT((first ? 1 : -1) * side * (*places)[i].y, 0) << "node " << i;
  }
  for (const auto& [a, b] : drawn.edges) {
    const double length = std::abs((*places)[a].x - (*places)[b].x);
    const bool near_pole =
        std::min(std::abs(drawn.nodes[a].middle.y), std::abs(drawn.nodes[b].middle.y)) > 0.9;
    if (length < 1 && !near_pole) widest = std::max(widest, length);
  }
  EXPECT_LT(widest, 0.25);
}

TEST(GraphLayout, does_not_unroll_a_cut_across_a_sheet) {
  const Shown shown = cut_across(grid(10, 2), 2, 0.05);
  EXPECT_FALSE(lay_out_unrolled(draw_graph(shown.graph, shown.traversal, GraphScope::kWhole)));
}

TEST(GraphLayout, both_kinds_fill_the_square_deterministically) {
  for (const auto& [name, soup] : mesh_classes()) {
    SCOPED_TRACE(name);
    Shown shown{world_of(soup), {}, {}};
    shown.graph = cut_graph(shown.world, {});
    shown.traversal = traverse_cut(shown.graph, 0);
    const DrawnGraph drawn = draw_graph(shown.graph, shown.traversal, GraphScope::kWhole);
    for (auto lay_out : {lay_out_by_position, lay_out_by_force}) {
      const GraphLayout places = lay_out(drawn);
      double farthest = 0;
      for (const Vec2& p : places) farthest = std::max({farthest, std::abs(p.x), std::abs(p.y)});
      const bool coincide = name == "pillow" && lay_out == lay_out_by_position;
      EXPECT_NEAR(farthest, coincide ? 0 : 1, 1e-9);
      EXPECT_EQ(lay_out(drawn), places);
    }
  }
}

TEST(GraphLayout, by_force_keeps_linked_nodes_closer_than_others) {
  const Shown shown = cut_across(torus(12, 16, 1, 0.4), 5, 0.03);
  const DrawnGraph drawn = draw_graph(shown.graph, shown.traversal, GraphScope::kWhole);
  const GraphLayout places = lay_out_by_force(drawn);
  double linked = 0, any = 0;
  for (const auto& [a, b] : drawn.edges) linked += glm::length(places[a] - places[b]);
  linked /= static_cast<double>(drawn.edges.size());
  Random random(1);
  for (int i = 0; i < 1000; ++i)
    any += glm::length(places[random.below(places.size())] - places[random.below(places.size())]) / 1000;
  EXPECT_LT(linked, 0.25 * any);
}

}  // namespace
}  // namespace kerf::test
