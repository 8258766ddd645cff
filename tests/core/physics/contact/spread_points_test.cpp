#include "core/physics/contact/collider_features.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "core/base/random.h"

namespace kerf {
namespace {

using Indices = std::vector<uint32_t>;

// The distance of a point from the nearest of those chosen.
double apart(const std::vector<Vec3>& points, const Indices& chosen, size_t count, const Vec3& p) {
  double least = 1e9;
  for (size_t i = 0; i < count; ++i) least = std::min(least, glm::distance(points[chosen[i]], p));
  return least;
}

TEST(SpreadPoints, are_each_the_farthest_from_those_before) {
  Random random(2);
  std::vector<Vec3> points(200);
  for (Vec3& p : points) p = {random.unit(), random.unit(), random.unit()};
  Indices chosen{17};
  choose_spread(points, 20, chosen);
  ASSERT_EQ(chosen.size(), 20u);
  EXPECT_EQ(chosen[0], 17u);
  for (size_t i = 1; i < chosen.size(); ++i) {
    const double own = apart(points, chosen, i, points[chosen[i]]);
    for (const Vec3& p : points) ASSERT_LE(apart(points, chosen, i, p), own);
  }
}

TEST(SpreadPoints, end_where_no_point_lies_apart) {
  const std::vector<Vec3> points{Vec3(0), Vec3(1, 0, 0), Vec3(0), Vec3(1, 0, 0)};
  Indices chosen;
  choose_spread(points, 4, chosen);
  EXPECT_EQ(chosen.size(), 2u);
  choose_spread({}, 4, chosen);
  EXPECT_EQ(chosen.size(), 2u);
}

TEST(SpreadPoints, that_are_extreme_are_the_corners_of_a_box_and_each_is_there_once) {
  std::vector<Vec3> points;
  for (int i = 0; i < 27; ++i) points.emplace_back(i % 3 - 1, i / 3 % 3 - 1, i / 9 - 1);
  Indices chosen{0};
  choose_extreme(points, chosen);
  Indices sorted = chosen;
  std::sort(sorted.begin(), sorted.end());
  EXPECT_EQ(std::unique(sorted.begin(), sorted.end()), sorted.end());
  for (const uint32_t corner : {0u, 2u, 6u, 8u, 18u, 20u, 24u, 26u})
    EXPECT_EQ(std::count(chosen.begin(), chosen.end(), corner), 1) << corner;
  EXPECT_LE(chosen.size(), 14u);
}

}  // namespace
}  // namespace kerf
