#include "core/mesh/weld.h"

#include <gtest/gtest.h>

#include <limits>

namespace kerf {
namespace {

UsableTriangles usable(const Soup& soup) {
  return std::move(*usable_triangles(soup, weld_positions(soup.positions), nullptr));
}

// A square with one corner repeated, and a point that is not a number.
Soup square() {
  Soup soup;
  soup.positions = {
      {0, 0, 0}, {1, 0, 0}, {1, 0, 1}, {0, 0, 0}, {0, 0, std::numeric_limits<double>::infinity()}};
  return soup;
}

TEST(UsableTriangles, use_welded_vertex_indices) {
  Soup soup = square();
  soup.triangles = {{1, 2, 3}};
  EXPECT_EQ(usable(soup).triangles, (std::vector<Soup::Triangle>{{1, 2, 0}}));
}

TEST(UsableTriangles, exclude_and_count_degenerate_triangles) {
  Soup soup = square();
  soup.triangles = {{0, 1, 2}, {0, 1, 3}, {1, 1, 2}, {0, 1, 4}, {1, 2, 3}};
  soup.materials = {1, 2, 3, 4, 5};
  const UsableTriangles found = usable(soup);
  EXPECT_EQ(found.triangles.size(), 2u);
  EXPECT_EQ(found.degenerate, 2u);
  EXPECT_EQ(found.non_finite, 1u);
  EXPECT_EQ(found.materials, (std::vector<uint16_t>{1, 5}));
}

TEST(UsableTriangles, keep_the_parts_that_are_not_empty) {
  Soup soup = square();
  soup.triangles = {{0, 1, 3}, {0, 1, 2}, {0, 1, 3}, {1, 2, 3}};
  soup.parts = {{"gone", 0, 1}, {"first", 0, 2}, {"all", 0, 4}, {"last", 2, 4}};
  const UsableTriangles found = usable(soup);
  ASSERT_EQ(found.parts.size(), 3u);
  EXPECT_EQ(found.parts[0].name, "first");
  EXPECT_EQ(found.parts[0].last, 1u);
  EXPECT_EQ(found.parts[1].last, 2u);
  EXPECT_EQ(found.parts[2].first, 1u);
}

}  // namespace
}  // namespace kerf
