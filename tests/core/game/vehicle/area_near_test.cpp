#include "core/game/vehicle/vehicle_model.h"

#include <gtest/gtest.h>

#include "core/base/deterministic_math.h"

namespace kerf {
namespace {

const Triangle kLarge{Vec3(-100, 0, -100), Vec3(100, 0, -100), Vec3(0, 0, 200)};

TEST(AreaNear, is_the_whole_area_of_a_triangle_inside_and_zero_outside) {
  const Triangle small{Vec3(0), Vec3(1, 0, 0), Vec3(0, 0, 2)};
  EXPECT_NEAR(area_within(small, {{0.3, 0, 0.3}, 3}), 1, 1e-12);
  EXPECT_EQ(area_within(small, {{0.3, 3.01, 0.3}, 3}), 0);
  EXPECT_EQ(area_within(small, {{-5, 0, 0}, 4.9}), 0);
}

TEST(AreaNear, is_the_intersection_disc_for_a_large_triangle) {
  for (const double height : {0.0, 0.5, 0.9}) {
    const double disc = kPi * (1 - height * height);
    EXPECT_NEAR(area_within(kLarge, {{0.2, height, 0.1}, 1}), disc, 0.12 * kPi) << height;
  }
}

TEST(AreaNear, of_two_halves_equals_that_of_the_whole) {
  const Ball ball{{0, 0.3, 20}, 5};
  const Vec3 middle = 0.5 * (kLarge[0] + kLarge[1]);
  const double halves =
      area_within({kLarge[0], middle, kLarge[2]}, ball) + area_within({middle, kLarge[1], kLarge[2]}, ball);
  EXPECT_NEAR(halves, area_within(kLarge, ball), 0.1 * halves);
}

}  // namespace
}  // namespace kerf
