#include "core/game/vehicle/drive.h"

#include "core/game/angle.h"
#include "core/game/match/recover.h"
#include "tests/support/game_files.h"

namespace kerf {
namespace {

// A match without enemies.
class Driving : public testing::Test {
 protected:
  void drive(int throttle, int steer, double seconds, bool handbrake = false) {
    Controls controls;
    controls.throttle = static_cast<int8_t>(throttle);
    controls.steer = static_cast<int8_t>(steer);
    controls.handbrake = handbrake;
    for (int t = 0; t < seconds * static_cast<double>(kTicksPerSecond); ++t) match_.tick(controls);
  }
  const Body& chassis() const { return match_.world().body(match_.vehicles()[0].chassis); }
  Vec3 position() const { return chassis().placement.position; }
  Vec3 axis(const Vec3& own) const { return chassis().placement.orientation * own; }
  double speed() const { return glm::dot(chassis().motion.velocity, axis({0, 0, 1})); }

  Match match_{{test::flat_rules(0, 0), 1, Difficulty::kNormal}};
};

TEST_F(Driving, a_vehicle_that_nobody_drives_stands_on_its_wheels) {
  drive(0, 0, 2);
  EXPECT_LT(glm::length(chassis().motion.velocity), 0.02);
  EXPECT_NEAR(position().y, 0, 0.03);
  EXPECT_GT(axis({0, 1, 0}).y, 0.9999);
  for (const Wheel& wheel : match_.vehicles()[0].wheels) EXPECT_TRUE(wheel.grounded);
}

TEST_F(Driving, throttle_drives_it_straight_on_and_backwards) {
  drive(100, 0, 4);
  EXPECT_GT(speed(), 10);
  EXPECT_GT(position().z, 15);
  EXPECT_NEAR(position().x, 0, 0.3);
  EXPECT_GT(axis({0, 1, 0}).y, 0.99);
  drive(-100, 0, 8);
  EXPECT_LT(speed(), -2);
}

TEST_F(Driving, brakes_stop_it_and_no_more) {
  drive(100, 0, 3);
  const double fast = speed(), before = position().z;
  drive(0, 0, 3, true);
  EXPECT_NEAR(speed(), 0, 0.1);
  EXPECT_LT(position().z - before, fast * fast / (2 * 5));
}

TEST_F(Driving, steering_to_the_left_turns_it_to_the_left_without_rolling_over) {
  drive(100, 0, 2);
  drive(60, 100, 2);
  EXPECT_GT(heading_of(axis({0, 0, 1})), 0.5);
  EXPECT_GT(position().x, 1);
  EXPECT_GT(axis({0, 1, 0}).y, 0.97);
}

TEST_F(Driving, it_does_not_leave_the_arena) {
  drive(100, 0, 12);
  EXPECT_LT(position().z, 100);
}

TEST(Recovery, a_vehicle_on_its_roof_is_put_upright_after_a_while) {
  test::LoneVehicle lone;
  Body& chassis = lone.world.body(lone.vehicle.chassis);
  chassis.placement = {{3, 1.6, 4}, turn_about({0, 0, 1}, kPi)};
  int ticks = 0;
  while (!recover_vehicle(lone.world, lone.vehicle, FreeSpace(), MatchTimes{}) && ticks < 1000) ++ticks;
  EXPECT_NEAR(ticks, 360, 2);
  EXPECT_GT((chassis.placement.orientation * Vec3(0, 1, 0)).y, 0.999);
  EXPECT_NEAR(chassis.placement.position.x, 3, 0.1);
}

TEST(Recovery, a_vehicle_without_wheels_stays_on_its_roof) {
  test::LoneVehicle lone;
  lone.world.body(lone.vehicle.chassis).placement = {{0, 1.6, 0}, turn_about({0, 0, 1}, kPi)};
  for (Wheel& wheel : lone.vehicle.wheels) wheel.attached = false;
  for (int t = 0; t < 1000; ++t)
    ASSERT_FALSE(recover_vehicle(lone.world, lone.vehicle, FreeSpace(), MatchTimes{}));
}

}  // namespace
}  // namespace kerf
