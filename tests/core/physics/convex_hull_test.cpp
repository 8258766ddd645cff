#include "core/physics/convex_hull.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/gtc/quaternion.hpp>
#include <map>
#include <string>
#include <utility>

#include "core/base/random.h"

namespace kerf::test {
namespace {

double volume_of(const ConvexHull& hull) {
  double volume = 0;
  for (const auto& [a, b, c] : hull.triangles) {
    const Vec3 &p = hull.positions[a], &q = hull.positions[b], &r = hull.positions[c];
    volume += glm::dot(p - hull.positions[0], glm::cross(q - hull.positions[0], r - hull.positions[0])) / 6;
  }
  return volume;
}

// Every side is used once in each direction.
bool is_closed(const ConvexHull& hull) {
  std::map<std::pair<uint32_t, uint32_t>, int> sides;
  for (const auto& t : hull.triangles) {
    for (size_t i = 0; i < 3; ++i) ++sides[{t[i], t[(i + 1) % 3]}];
  }
  return std::all_of(sides.begin(), sides.end(), [&](const auto& side) {
    const auto other = sides.find({side.first.second, side.first.first});
    return side.second == 1 && other != sides.end();
  });
}

// The largest height of a point over a plane of the hull.
double outside(const ConvexHull& hull, std::span<const Vec3> points) {
  double most = -1e300;
  for (const auto& [a, b, c] : hull.triangles) {
    const Vec3 n = glm::cross(hull.positions[b] - hull.positions[a], hull.positions[c] - hull.positions[a]);
    if (!(glm::length(n) > 1e-12)) continue;
    for (const Vec3& p : points) most = std::max(most, glm::dot(glm::normalize(n), p - hull.positions[a]));
  }
  return most;
}

Vec3 random_point(Random& random) {
  return {random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1)};
}

TEST(ConvexHull, of_a_cube_has_its_corners) {
  Random random(1);
  std::vector<Vec3> points;
  for (int i = 0; i < 500; ++i) points.push_back(0.99 * random_point(random));
  for (int i = 0; i < 8; ++i) points.emplace_back(i & 1 ? 1 : -1, i & 2 ? 1 : -1, i & 4 ? 1 : -1);
  const ConvexHull hull = convex_hull(points, 64);
  EXPECT_EQ(hull.positions.size(), 8u);
  EXPECT_EQ(hull.triangles.size(), 12u);
  EXPECT_TRUE(is_closed(hull));
  EXPECT_NEAR(volume_of(hull), 8, 1e-12);
}

TEST(ConvexHull, of_a_sphere_is_reduced) {
  for (uint64_t seed = 1; seed <= 5; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Random random(seed);
    const Vec3 middle = 100.0 * random_point(random);
    std::vector<Vec3> points;
    while (points.size() < 3000) {
      const Vec3 p = random_point(random);
      if (glm::length(p) < 1 && glm::length(p) > 0) points.push_back(middle + glm::normalize(p));
    }
    const ConvexHull hull = convex_hull(points, 64);
    EXPECT_LE(hull.positions.size(), 64u);
    EXPECT_GE(hull.positions.size(), 60u);
    EXPECT_TRUE(is_closed(hull));
    EXPECT_GT(volume_of(hull), 0.85 * 4.18879);
    EXPECT_LT(outside(hull, hull.positions), 1e-3);
    EXPECT_LT(outside(hull, points), 0.15);
    for (const Vec3& p : hull.positions) EXPECT_NE(std::find(points.begin(), points.end(), p), points.end());
  }
}

TEST(ConvexHull, of_flat_points_is_empty) {
  Random random(7);
  std::vector<Vec3> points;
  EXPECT_TRUE(convex_hull(points, 64).triangles.empty());
  for (int i = 0; i < 200; ++i) points.emplace_back(random.uniform(-1, 1), random.uniform(-1, 1), 3);
  EXPECT_TRUE(convex_hull(points, 64).triangles.empty());
  for (Vec3& p : points) p.y = 2 * p.x;
  EXPECT_TRUE(convex_hull(points, 64).triangles.empty());
  for (Vec3& p : points) p = Vec3(1);
  EXPECT_TRUE(convex_hull(points, 64).triangles.empty());
  points.clear();
  for (int i = 0; i < 8; ++i) points.emplace_back(i & 1, i >> 1 & 1, 1e-10 * (i >> 2));
  EXPECT_TRUE(convex_hull(points, 64).triangles.empty()) << "of a slab much thinner than it resolves";
}

TEST(ThickenedSheet, has_the_volume_of_the_sheet) {
  const std::vector<std::array<uint32_t, 3>> triangles{{0, 1, 2}, {0, 0, 1}, {0, 2, 3}};
  for (uint64_t seed = 1; seed <= 20; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Random random(seed);
    const glm::dquat turn =
        glm::normalize(glm::dquat(random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1), 0.1));
    const Vec3 at = random_point(random);
    std::vector<Vec3> positions{{0, 0, 0}, {2, 0, 0}, {2, 1, 0}, {0, 1, 0}};
    for (Vec3& p : positions) p = at + turn * p;
    const std::vector<Vec3> points = thickened_sheet(positions, triangles, 0.01);
    EXPECT_EQ(points.size(), 12u);
    const ConvexHull hull = convex_hull(points, 64);
    EXPECT_TRUE(is_closed(hull));
    EXPECT_NEAR(volume_of(hull), 0.02, 1e-3 * 0.02);
  }
}

}  // namespace
}  // namespace kerf::test
