#include "core/base/deterministic_math.h"

#include <gtest/gtest.h>

#include <cmath>

namespace kerf {
namespace {

TEST(Angles, agree_with_the_library) {
  for (double x = -20; x < 20; x += 0.037) {
    EXPECT_NEAR(sin_cos(x).sin, std::sin(x), 1e-13);
    EXPECT_NEAR(sin_cos(x).cos, std::cos(x), 1e-13);
    const double y = x * x - 40;
    EXPECT_NEAR(det::atan2(y, x), std::atan2(y, x), 1e-13);
    EXPECT_NEAR(heading_of(direction_of(wrapped(x), 0.3)), wrapped(x), 1e-12);
  }
  EXPECT_EQ(det::atan2(0, 0), 0);
}

TEST(Angles, are_wrapped_by_whole_turns) {
  for (double x = -20; x < 20; x += 0.37) {
    EXPECT_LE(std::abs(wrapped(x)), kPi + 1e-12);
    EXPECT_NEAR(std::remainder(wrapped(x) - x, 2 * kPi), 0, 1e-12);
  }
}

TEST(Angles, turn_by_the_right_hand_rule) {
  EXPECT_NEAR(glm::distance(axis_angle({0, 1, 0}, kPi / 2) * Vec3(0, 0, 1), Vec3(1, 0, 0)), 0, 1e-12);
  EXPECT_NEAR(glm::distance(axis_angle({1, 0, 0}, kPi / 2) * Vec3(0, 1, 0), Vec3(0, 0, 1)), 0, 1e-12);
}

TEST(Angles, direction_round_trips) {
  for (double heading = -3; heading < 3; heading += 0.41) {
    for (double pitch = -1.5; pitch < 1.5; pitch += 0.23) {
      const Vec3 direction = direction_of(heading, pitch);
      EXPECT_NEAR(glm::length(direction), 1, 1e-12);
      EXPECT_NEAR(heading_of(direction), heading, 1e-11);
      EXPECT_NEAR(pitch_of(direction), pitch, 1e-11);
    }
  }
}

}  // namespace
}  // namespace kerf
