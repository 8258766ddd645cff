#include "core/mesh/measures.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "core/base/random.h"

namespace kerf {
namespace {

Vec3 random_point(Random& random) {
  return {random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1)};
}

// The minimum distance from a grid of samples of a triangle.
double sampled_distance(const Vec3& p, const Triangle& t) {
  double least = 1e9;
  constexpr int kSamples = 60;
  for (int i = 0; i <= kSamples; ++i) {
    for (int j = 0; i + j <= kSamples; ++j) {
      const double u = double(i) / kSamples, v = double(j) / kSamples;
      least = std::min(least, glm::distance(p, t[0] + u * (t[1] - t[0]) + v * (t[2] - t[0])));
    }
  }
  return least;
}

TEST(PointToTriangle, is_the_minimum_over_all_points_of_the_triangle) {
  Random random(9);
  for (int i = 0; i < 200; ++i) {
    const Triangle t{random_point(random), random_point(random), random_point(random)};
    const Vec3 p = 2.0 * random_point(random);
    const double found = std::sqrt(squared_distance(p, t)), sampled = sampled_distance(p, t);
    ASSERT_LE(found, sampled + 1e-12) << "triangle " << i << " of seed 9";
    ASSERT_GE(found, sampled - 0.06);
    ASSERT_NEAR(glm::distance(p, nearest_point(p, t)), found, 1e-9);
  }
}

TEST(PointToTriangle, is_exact_above_the_face_next_to_an_edge_and_beyond_a_corner) {
  const Triangle t{Vec3(0), Vec3(2, 0, 0), Vec3(0, 0, 2)};
  EXPECT_NEAR(squared_distance({0.5, 3, 0.5}, t), 9, 1e-12);
  EXPECT_NEAR(squared_distance({1, 1, -2}, t), 5, 1e-12);
  EXPECT_NEAR(squared_distance({-3, 0, -4}, t), 25, 1e-12);
  EXPECT_EQ(nearest_point({0.5, 3, 0.5}, t), Vec3(0.5, 0, 0.5));
}

TEST(PointToTriangle, is_exact_for_triangles_of_any_size) {
  for (const int exponent : {-480, -260, -190, 0, 190, 260, 480}) {
    const double unit = std::ldexp(1.0, exponent);
    const Triangle t{Vec3(0), unit * Vec3(2, 0, 0), unit * Vec3(0, 0, 2)};
    const Vec3 above = unit * Vec3(0.5, 3, 0.5);
    EXPECT_EQ(squared_distance(above, t), std::ldexp(9.0, 2 * exponent)) << exponent;
    EXPECT_EQ(nearest_point(above, t), unit * Vec3(0.5, 0, 0.5)) << exponent;
  }
}

TEST(PointToTriangle, of_a_degenerate_triangle_is_measured_to_its_line_or_point) {
  EXPECT_NEAR(squared_distance({1, 2, 0}, {Vec3(0), Vec3(4, 0, 0), Vec3(2, 0, 0)}), 4, 1e-12);
  EXPECT_NEAR(squared_distance({1, 2, 2}, {Vec3(1, 0, 0), Vec3(1, 0, 0), Vec3(1, 0, 0)}), 8, 1e-12);
}

}  // namespace
}  // namespace kerf
