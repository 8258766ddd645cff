#include "core/mesh/orientation.h"

#include <gtest/gtest.h>

#include <numeric>

#include "core/mesh/weld.h"
#include "tests/support/made_meshes.h"

namespace kerf::test {
namespace {

// The number of other patches around each patch of a soup.
std::vector<uint32_t> enclosing(const Soup& soup, uint32_t rays) {
  const std::vector<uint32_t> first = weld_positions(soup.positions);
  std::vector<Soup::Triangle> triangles;
  for (auto t : soup.triangles) triangles.push_back({first[t[0]], first[t[1]], first[t[2]]});
  const auto patches = find_patches(triangles, group_sides(triangles, soup.positions.size()), nullptr);
  std::vector<uint32_t> all_patches(patches->count());
  std::iota(all_patches.begin(), all_patches.end(), 0u);
  return count_enclosing(soup.positions, triangles, *patches, all_patches, rays);
}

// Whether each is inside another one.
std::vector<bool> enclosed(const Soup& soup) {
  const std::vector<uint32_t> around = enclosing(soup, 1);
  return {around.begin(), around.end()};
}

using Flags = std::vector<bool>;

TEST(EnclosedPatches, are_inside_a_closed_patch) {
  const Soup ball = sphere(8, 12, 1);
  EXPECT_EQ(enclosed(both(ball, moved(ball, {0.1, 0.05, 0}, 0.5))), (Flags{false, true}));
  EXPECT_EQ(enclosed(both(ball, moved(ball, {2.2, 0.05, 0}, 0.5))), (Flags{false, false}));
  EXPECT_EQ(enclosed(both(ball, moved(grid(2, 0.5), {0.1, 0.05, 0}, 1))), (Flags{false, true}))
      << "open ones, too";
}

TEST(EnclosedPatches, are_not_inside_the_hole_of_a_torus_or_a_tube) {
  const Soup ball = sphere(8, 12, 1);
  EXPECT_EQ(enclosed(both(torus(24, 16, 1, 0.3), moved(ball, {0.02, 0.01, 0.03}, 0.2))),
            (Flags{false, false}));
  EXPECT_EQ(enclosed(both(tube(8, 24, 1, 4), moved(ball, {0.02, 0.01, 0.03}, 0.2))), (Flags{false, false}));
}

// With a third part far along the axis of the ring, rays go along the ring's plane and meet it twice.
TEST(EnclosedPatches, are_not_detected_by_a_ray_that_enters_and_leaves) {
  const Soup ball = sphere(8, 12, 1), ring = torus(24, 16, 1, 0.3);
  const Soup beside = both(moved(ball, {0.02, 0.01, 0.03}, 0.2), moved(ball, {0, 50, 0}, 1));
  EXPECT_EQ(enclosed(both(ring, beside)), (Flags{false, false, false}));
}

TEST(EnclosedPatches, may_be_nested) {
  const Soup ball = sphere(8, 12, 1);
  const Soup three = both(ball, both(moved(ball, {0.1, 0.05, 0}, 0.7), moved(ball, {0.12, 0.04, 0}, 0.3)));
  EXPECT_EQ(enclosed(three), (Flags{false, true, true}));
  EXPECT_EQ(enclosing(three, 1), (std::vector<uint32_t>{0, 1, 2}));
  EXPECT_EQ(enclosing(three, 4), (std::vector<uint32_t>{0, 1, 2}));
}

// A cube that passes through the wall of another one, with a bounding box inside that of both: some of its
// vertices are inside, others are not.
TEST(EnclosedPatches, require_all_rays_to_be_inside) {
  const Soup ball = sphere(8, 12, 1), through = moved(ball, {0.6, 0.6, 0.1}, 0.35);
  EXPECT_EQ(enclosing(both(ball, through), 8), (std::vector<uint32_t>{0, 0}));
}

}  // namespace
}  // namespace kerf::test
