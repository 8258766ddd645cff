#include "core/game/driver/steering.h"

#include <gtest/gtest.h>

#include <array>

#include "core/base/deterministic_math.h"
#include "core/base/ids.h"
#include "tests/core/game/driver/duel.h"

namespace kerf {
namespace {

constexpr int kSecondOfTicks = static_cast<int>(kTicksPerSecond);

// A vehicle at the origin that looks along z; only the test moves it.
class SteeringTest : public testing::Test {
 protected:
  // The controls after so many ticks towards an opponent there.
  Controls drive(Steering& steering, const Vec3& at, int ticks, double distance = 5) {
    Controls& controls = duel_.vehicle(0).controls;
    for (int t = 0; t < ticks; ++t) steering.drive(duel_.view(), at, distance, 1, controls);
    return controls;
  }

  test::Duel duel_{std::array{Vec3(0), Vec3(0, 0, 200)}};
};

TEST_F(SteeringTest, drives_at_an_opponent_ahead_and_turns_towards_one_at_the_side) {
  for (uint64_t seed = 1; seed <= 5; ++seed) {
    SCOPED_TRACE(seed);
    Steering straight(seed), left(seed), right(seed);
    EXPECT_GT(drive(straight, {0, 0, 60}, 12).throttle, 50);
    EXPECT_GT(drive(left, {60, 0, 20}, 12).steer, 20);
    EXPECT_LT(drive(right, {-60, 0, 20}, 12).steer, -20);
    EXPECT_FALSE(duel_.vehicle(0).controls.handbrake);
  }
}

TEST_F(SteeringTest, keeps_its_distance_from_a_close_opponent) {
  // It is behind: the place on the circle around it lies ahead.
  Steering steering(1);
  EXPECT_GT(drive(steering, {0, 0, -3}, 12, 25).throttle, 50);
}

TEST_F(SteeringTest, does_not_drive_into_obstacles_ahead) {
  duel_.traffic = {{{0, 0, 4}, 1.5, Vec3(0), BodyId{}},
                   {{2.5, 0, 3.5}, 1.5, Vec3(0), BodyId{}},
                   {{-2.5, 0, 3.5}, 1.5, Vec3(0), BodyId{}}};
  Steering steering(1);
  EXPECT_LT(drive(steering, {0, 0, 60}, 12).throttle, 0) << "back, and around";
  duel_.traffic.clear();
  EXPECT_GT(drive(steering, {0, 0, 60}, kSecondOfTicks / 2).throttle, 0);
}

TEST_F(SteeringTest, brakes_if_too_fast_for_the_free_distance) {
  duel_.chassis(0).motion.velocity = {0, 0, 15};
  duel_.traffic = {{{0, 0, 14}, 3, Vec3(0), BodyId{}},
                   {{6, 0, 14}, 3, Vec3(0), BodyId{}},
                   {{-6, 0, 14}, 3, Vec3(0), BodyId{}}};
  Steering steering(1);
  EXPECT_LT(drive(steering, {0, 0, 60}, 12).throttle, 0);
}

TEST_F(SteeringTest, reverses_for_a_while_when_stuck) {
  Steering steering(1);
  ASSERT_GT(drive(steering, {0, 0, 60}, kSecondOfTicks / 2).throttle, 0);
  int back = 0;
  for (int t = 0; t < 2 * kSecondOfTicks; ++t) back += drive(steering, {0, 0, 60}, 1).throttle < 0;
  EXPECT_GT(back, kSecondOfTicks / 2);
}

}  // namespace
}  // namespace kerf
