#include "core/physics/contact/collider.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "core/base/random.h"

namespace kerf {
namespace {

using Indices = std::vector<uint32_t>;

// The distance of a point from the nearest of those chosen.
double apart(const std::vector<Vec3>& points, const Indices& selected, size_t count, const Vec3& p) {
  double least = 1e9;
  for (size_t i = 0; i < count; ++i) least = std::min(least, glm::distance(points[selected[i]], p));
  return least;
}

TEST(SpreadPoints, are_each_farthest_from_the_previous_ones) {
  Random random(2);
  std::vector<Vec3> points(200);
  for (Vec3& p : points) p = {random.unit(), random.unit(), random.unit()};
  Indices selected{17};
  select_spread_points(points, 20, selected);
  ASSERT_EQ(selected.size(), 20u);
  EXPECT_EQ(selected[0], 17u);
  for (size_t i = 1; i < selected.size(); ++i) {
    const double own = apart(points, selected, i, points[selected[i]]);
    for (const Vec3& p : points) ASSERT_LE(apart(points, selected, i, p), own);
  }
}

TEST(SpreadPoints, stop_at_coinciding_points) {
  const std::vector<Vec3> points{Vec3(0), Vec3(1, 0, 0), Vec3(0), Vec3(1, 0, 0)};
  Indices selected;
  select_spread_points(points, 4, selected);
  EXPECT_EQ(selected.size(), 2u);
  select_spread_points({}, 4, selected);
  EXPECT_EQ(selected.size(), 2u);
}

TEST(SpreadPoints, include_the_corners_of_a_box_exactly_once) {
  std::vector<Vec3> points;
  for (int i = 0; i < 27; ++i) points.emplace_back(i % 3 - 1, i / 3 % 3 - 1, i / 9 - 1);
  Indices selected{0};
  select_extreme(points, selected);
  Indices sorted = selected;
  std::sort(sorted.begin(), sorted.end());
  EXPECT_EQ(std::unique(sorted.begin(), sorted.end()), sorted.end());
  for (const uint32_t corner : {0u, 2u, 6u, 8u, 18u, 20u, 24u, 26u})
    EXPECT_EQ(std::count(selected.begin(), selected.end(), corner), 1) << corner;
  EXPECT_LE(selected.size(), 14u);
}

TEST(ExtremePoints, are_those_along_axes_and_diagonals) {
  Random random(3);
  std::vector<Vec3> points(300);
  for (Vec3& p : points)
    p = glm::normalize(Vec3(random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1)));
  std::set<uint32_t> expected;
  for (int i = 0; i < 27; ++i) {
    const Vec3 way(i % 3 - 1, i / 3 % 3 - 1, i / 9 - 1);
    const double length2 = glm::dot(way, way);
    if (length2 != 1 && length2 != 3) continue;
    const auto farthest =
        std::ranges::max_element(points, {}, [&](const Vec3& p) { return glm::dot(p, way); });
    expected.insert(static_cast<uint32_t>(farthest - points.begin()));
  }
  Indices selected;
  select_extreme(points, selected);
  EXPECT_EQ(selected.size(), expected.size());
  EXPECT_EQ(std::set<uint32_t>(selected.begin(), selected.end()), expected);
}

}  // namespace
}  // namespace kerf
