#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "core/kerf.h"
#include "tests/api/sheets.h"

namespace kerf::test {
namespace {

// Checks that each hit lies where its barycentrics put it, and returns the number of hits.
size_t check_hits(const Hits& hits) {
  size_t count = 0;
  for (size_t i = 0; i < hits.distances.size(); ++i) {
    if (hits.bodies[i] == KERF_NO_BODY) continue;
    ++count;
    double sum = 0, length = 0;
    for (size_t k = 0; k < 3; ++k) {
      sum += hits.barycentrics[3 * i + k];
      length += hits.normals[3 * i + k] * hits.normals[3 * i + k];
      EXPECT_GE(hits.barycentrics[3 * i + k], 0);
    }
    EXPECT_NEAR(sum, 1, 1e-12);
    EXPECT_NEAR(length, 1, 1e-12);
  }
  return count;
}

TEST(Hits, describe_the_point_of_the_face) {
  World world;
  world.add(sheet(10));
  world.cut(through_the_middle(), {.rim = KERF_RIM_SMOOTH});
  std::mt19937 random(7);
  std::uniform_real_distribution<double> unit(0, 1);
  std::vector<double> from, along;
  for (int i = 0; i < 500; ++i) {
    from.insert(from.end(), {unit(random), 1, unit(random)});
    along.insert(along.end(), {0, -2, 0});
  }
  const Hits hits = world.nearest_hits(from, along);
  EXPECT_GT(check_hits(hits), 450u);
  std::array<size_t, 2> by_side{};
  for (size_t i = 0; i < hits.distances.size(); ++i) {
    if (hits.bodies[i] == KERF_NO_BODY) continue;
    EXPECT_NEAR(hits.positions[3 * i], from[3 * i], 1e-12);
    EXPECT_NEAR(hits.positions[3 * i + 1], 0, 1e-12);
    EXPECT_NEAR(hits.normals[3 * i + 1], 1, 1e-12);
    EXPECT_FALSE(hits.is_cut[i]);
    // The two sides are two pieces.
    const bool right = from[3 * i] > 0.5;
    by_side[right] += hits.pieces[i] > 0;
    EXPECT_EQ(hits.pieces[i] > 0, by_side[right] > 0);
  }
  EXPECT_NE(by_side[0] > 0, by_side[1] > 0);
}

TEST(Hits, closest_points_are_those_of_the_plane) {
  World world;
  world.add(sheet(10));
  const std::vector<double> points{0.3, 0.4, 0.7, 0.25, -2, 0.5, 2, 0, 0.5, 0.5, 100, 0.5};
  const Hits hits = world.closest_points(points, 10);
  EXPECT_EQ(check_hits(hits), 3u);
  EXPECT_NEAR(hits.distances[0], 0.4, 1e-12);
  EXPECT_NEAR(hits.distances[1], 2, 1e-12);
  EXPECT_NEAR(hits.distances[2], 1, 1e-12);
  EXPECT_NEAR(hits.positions[6], 1, 1e-12);
  EXPECT_EQ(hits.faces[3], KERF_NO_FACE);
  EXPECT_THROW((void)world.closest_points(points, -1), InvalidArgument);
  EXPECT_THROW((void)world.closest_points(std::vector<double>{0, NAN, 0}), InvalidArgument);
}

}  // namespace
}  // namespace kerf::test
