#include "core/mesh/mesh.h"

#include <gtest/gtest.h>

#include <cmath>

namespace kerf {
namespace {

TEST(Triangle, area_is_half_base_times_height) {
  EXPECT_NEAR(triangle_area({Vec3(1, 2, 3), Vec3(5, 2, 3), Vec3(3, 2, 9)}), 12, 1e-12);
  EXPECT_EQ(triangle_area({Vec3(0), Vec3(1, 1, 1), Vec3(2, 2, 2)}), 0);
}

TEST(Triangle, area_neither_overflows_nor_vanishes_at_any_size) {
  for (const int exponent : {-510, -500, -330, -258, 0, 258, 266, 500}) {
    const auto at = [&](double x, double y) {
      return Vec3(std::ldexp(x, exponent), std::ldexp(y, exponent), std::ldexp(1.0, exponent));
    };
    EXPECT_EQ(triangle_area({at(1, 2), at(4, 2), at(1, 6)}), std::ldexp(6.0, 2 * exponent)) << exponent;
    EXPECT_EQ(triangle_area({at(1, 1), at(2, 2), at(4, 4)}), 0) << exponent;
    // A power of two changes no digit.
    const double plain = triangle_area({Vec3(0), Vec3(0.3, 0.7, 0.1), Vec3(0.9, -0.2, 0.4)});
    const Triangle odd{Vec3(0), std::ldexp(1.0, exponent) * Vec3(0.3, 0.7, 0.1),
                       std::ldexp(1.0, exponent) * Vec3(0.9, -0.2, 0.4)};
    EXPECT_EQ(triangle_area(odd), std::ldexp(plain, 2 * exponent)) << exponent;
  }
}

TEST(Triangle, finds_its_longest_edge_at_any_position) {
  const Vec3 a(0), b(3, 0, 0), c(0, 4, 0);
  EXPECT_EQ(longest_edge2({a, b, c}), 25);
  EXPECT_EQ(longest_edge2({b, c, a}), 25);
  EXPECT_EQ(longest_edge2({c, a, b}), 25);
}

TEST(Triangle, computes_the_cosine_of_its_smallest_angle) {
  EXPECT_NEAR(largest_cosine({Vec3(0), Vec3(1, 0, 0), Vec3(0, 1, 0)}), std::sqrt(0.5), 1e-12);
  EXPECT_NEAR(largest_cosine({Vec3(0), Vec3(1, 0, 0), Vec3(0.5, std::sqrt(0.75), 0)}), 0.5, 1e-12);
  EXPECT_EQ(largest_cosine({Vec3(0), Vec3(1, 0, 0), Vec3(0)}), 1) << "a degenerate one";
}

TEST(Triangle, computes_a_cosine_from_its_own_corners_only) {
  const Triangle even{Vec3(0), Vec3(1, 0, 0), Vec3(0.5, std::sqrt(0.75), 0)};
  const std::array<Triangle, 2> row{even, Triangle{Vec3(1e9, 0, 0), Vec3(0), Vec3(1)}};
  EXPECT_NEAR(largest_cosine(row[0]), 0.5, 1e-12);
}

}  // namespace
}  // namespace kerf
