#include "core/mesh/soup_topology.h"

#include <gtest/gtest.h>

#include "core/mesh/weld.h"
#include "tests/support/made_meshes.h"

namespace kerf::test {
namespace {

// The triangles of a soup between welded positions.
struct Welded {
  explicit Welded(const Soup& soup) {
    const std::vector<uint32_t> first = weld_positions(soup.positions);
    for (auto t : soup.triangles) triangles.push_back({first[t[0]], first[t[1]], first[t[2]]});
    edges = group_sides(triangles, soup.positions.size());
    patches = std::move(*find_patches(triangles, edges, nullptr));
  }
  size_t components() const { return count_components(patches, edges); }

  std::vector<Soup::Triangle> triangles;
  SoupEdges edges;
  Patches patches;
};

TEST(Patches, of_manifold_meshes_are_their_components) {
  const Soup ball = sphere(6, 8, 1);
  const Welded two(both(ball, moved(grid(3, 1), {5, 0, 0}, 1)));
  ASSERT_EQ(two.patches.count(), 2u);
  EXPECT_EQ(two.patches.triangles_of(0).size(), ball.triangles.size());
  EXPECT_TRUE(two.patches.closed[0]);
  EXPECT_FALSE(two.patches.closed[1]);
  EXPECT_EQ(two.components(), 2u);
  for (const uint32_t t : two.patches.triangles_of(1)) EXPECT_EQ(two.patches.patch_of[t], 1u);
}

TEST(Patches, end_at_an_edge_of_three_triangles_unlike_components) {
  const Welded pages(book(5));
  EXPECT_EQ(pages.patches.count(), 5u);
  EXPECT_EQ(pages.components(), 1u);
}

TEST(Patches, with_inconsistent_winding_are_not_closed) {
  Soup ball = sphere(6, 8, 1);
  EXPECT_TRUE(Welded(ball).patches.closed[0]);
  std::swap(ball.triangles[10][0], ball.triangles[10][1]);
  EXPECT_FALSE(Welded(ball).patches.closed[0]);
}

// Two boxes.
TEST(Patches, of_closed_parts_with_a_common_edge_are_closed) {
  const Welded boxes(both(brick({1, 1, 1}), moved(brick({1, 1, 1}), {1, 1, 0}, 1)));
  EXPECT_EQ(boxes.patches.closed, (std::vector<bool>{true, true}));
  EXPECT_EQ(boxes.components(), 1u);
}

}  // namespace
}  // namespace kerf::test
