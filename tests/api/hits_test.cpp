#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstddef>
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

TEST(Hits, free_reads_no_member_beyond_the_size_of_the_struct) {
  kerf_hits hits = KERF_HITS_INIT;
  hits.size = offsetof(kerf_hits, owner);
  hits.owner = &hits;  // of the program, in the memory that follows its struct
  kerf_hits_free(&hits);
  EXPECT_EQ(hits.owner, &hits);
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

using Point = std::array<double, 3>;
using Corners = std::array<Point, 3>;

// Returns true if the part of a triangle within all six planes of a box has a point (I. Sutherland, G.
// Hodgman: Reentrant polygon clipping, 1974).
bool clips(const Corners& triangle, const Point& min, const Point& max) {
  std::vector<Point> polygon(triangle.begin(), triangle.end());
  for (size_t k = 0; k < 3; ++k) {
    for (const double sign : {1.0, -1.0}) {
      const auto depth = [&](const Point& p) { return sign > 0 ? p[k] - min[k] : max[k] - p[k]; };
      std::vector<Point> kept;
      for (size_t i = 0; i < polygon.size(); ++i) {
        const Point &a = polygon[i], &b = polygon[(i + 1) % polygon.size()];
        if (depth(a) >= 0) kept.push_back(a);
        if ((depth(a) < 0) == (depth(b) < 0)) continue;
        const double share = depth(a) / (depth(a) - depth(b));
        Point& p = kept.emplace_back();
        for (size_t c = 0; c < 3; ++c) p[c] = a[c] + share * (b[c] - a[c]);
        p[k] = sign > 0 ? min[k] : max[k];
      }
      polygon = std::move(kept);
    }
  }
  return !polygon.empty();
}

TEST(Hits, faces_in_a_box_are_those_that_clipping_leaves) {
  World world;
  BodyDesc desc;
  desc.position = {0.1, 0.2, 0.3};
  desc.orientation = {0.5, 0.5, 0.5, 0.5};
  const std::array bodies{world.add(box(4)), world.add(box(7), desc)};
  const auto corners_in_world = [&](size_t which, uint32_t face) {
    const std::vector<double> own = world.corners(bodies[which], {&face, 1});
    Corners corners;
    for (size_t i = 0; i < 3; ++i) {
      const double *p = &own[3 * i], turned[] = {p[2], p[0], p[1]};  // about (1, 1, 1) by 120 degrees
      for (size_t k = 0; k < 3; ++k) corners[i][k] = which == 0 ? p[k] : turned[k] + desc.position[k];
    }
    return corners;
  };
  std::mt19937 random(3);
  std::uniform_real_distribution<double> unit(-0.2, 1.4);
  size_t found = 0;
  for (int i = 0; i < 100; ++i) {
    Point min{unit(random), unit(random), unit(random)}, max{unit(random), unit(random), unit(random)};
    for (size_t k = 0; k < 3; ++k) {
      if (min[k] > max[k]) std::swap(min[k], max[k]);
      if (i % 3 > 0) max[k] = min[k] + 0.1 * (max[k] - min[k]);
    }
    std::vector<std::pair<BodyId, uint32_t>> wanted, hit;
    for (size_t which = 0; which < 2; ++which) {
      for (const uint32_t face : world.faces(bodies[which])) {
        if (clips(corners_in_world(which, face), min, max)) wanted.emplace_back(bodies[which], face);
      }
    }
    const Hits hits = world.faces_in_box(min, max);
    for (size_t k = 0; k < hits.faces.size(); ++k) hit.emplace_back(hits.bodies[k], hits.faces[k]);
    ASSERT_EQ(hit, wanted) << "box " << i;
    found += check_hits(hits);
  }
  EXPECT_GT(found, 1000u);
  EXPECT_EQ(world.faces_in_box({0, 0, 0}, {0, 0, 0}).faces.size(), 3u);  // of a corner, touched
  EXPECT_THROW((void)world.faces_in_box({0, 1, 0}, {1, 0, 1}), InvalidArgument);
  EXPECT_THROW((void)world.faces_in_box({0, 0, NAN}, {1, 1, 1}), InvalidArgument);
}

}  // namespace
}  // namespace kerf::test
