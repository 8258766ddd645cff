#include "core/game/vehicle/vehicle.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "core/base/deterministic_math.h"
#include "core/base/ids.h"
#include "tests/support/game_files.h"

namespace kerf {
namespace {

class GunTest : public testing::Test {
 protected:
  void point_at(double heading, double pitch) {
    lone_.vehicle.controls.heading = static_cast<int32_t>(heading / Controls::kAimStep);
    lone_.vehicle.controls.pitch = static_cast<int32_t>(pitch / Controls::kAimStep);
  }
  void aim_for(double seconds) {
    for (int t = 0; t < seconds * static_cast<double>(kTicksPerSecond); ++t) aim(lone_.world, lone_.vehicle);
  }
  // Whether it overheated.
  bool trigger_for(double seconds, bool fire) {
    bool overheated = false;
    lone_.vehicle.controls.fire = fire;
    for (int t = 0; t < seconds * static_cast<double>(kTicksPerSecond); ++t)
      overheated |= trigger(lone_.vehicle, speed_, rules_);
    return overheated;
  }
  Gun& gun() { return lone_.vehicle.gun; }

  test::LoneVehicle lone_;
  LaserRules rules_;
  double speed_ = 0;  // m/s
};

TEST_F(GunTest, turns_at_its_maximum_rate_and_stops_on_target) {
  point_at(1, 0.2);
  aim_for(1.5 / kTicksPerSecond);
  const double once = gun().yaw;
  EXPECT_GT(once, 0);
  EXPECT_LE(once, 2 * 4.5 * kTick + 1e-12);
  aim_for(1);
  EXPECT_NEAR(gun().yaw, 1, 1e-3);
  EXPECT_NEAR(gun().pitch, 0.2, 1e-3);
}

TEST_F(GunTest, turns_the_shorter_way_within_its_limits) {
  gun().yaw = 3;
  point_at(-3, 1.5);
  aim_for(0.2);
  EXPECT_NEAR(gun().yaw, -3, 1e-3) << "across the back";
  aim_for(2);
  EXPECT_NEAR(gun().pitch, lone_.vehicle.what().turret.barrel.pitch.high, 1e-12);
}

TEST_F(GunTest, aims_in_world_space_against_the_motion_of_the_chassis) {
  lone_.world.body(lone_.vehicle.chassis).placement.orientation = axis_angle({0, 1, 0}, 0.5);
  point_at(1.25, 0);
  aim_for(2);
  EXPECT_NEAR(gun().yaw, 0.75, 1e-3);
}

TEST_F(GunTest, neither_turns_nor_fires_when_dead_or_lost) {
  point_at(1, 0);
  lone_.vehicle.alive = false;
  aim_for(1);
  EXPECT_EQ(gun().yaw, 0);
  trigger_for(0.1, true);
  EXPECT_FALSE(gun().firing);
  lone_.vehicle.alive = true;
  gun().barrel_attached = false;
  aim_for(1);
  trigger_for(0.1, true);
  EXPECT_EQ(gun().yaw, 0);
  EXPECT_FALSE(gun().firing);
}

TEST_F(GunTest, drains_energy_by_the_rules_and_recharges_while_off) {
  rules_.heating = 0;
  lone_.vehicle.controls.width = 50;
  trigger_for(2, true);
  EXPECT_TRUE(gun().firing);
  EXPECT_NEAR(gun().energy, 1 - 2 * rules_.drain, 1e-9);
  trigger_for(1, false);
  EXPECT_FALSE(gun().firing);
  EXPECT_NEAR(gun().energy, 1 - 2 * rules_.drain + rules_.charge, 1e-9);
}

TEST_F(GunTest, recharges_faster_with_vehicle_speed_up_to_a_limit) {
  rules_.charge_driving = 3 * rules_.charge;
  for (const double share : {0.0, 0.25, 1.0, 4.0}) {
    gun().energy = 0;
    speed_ = share * LaserRules::kDriving;
    trigger_for(1, false);
    EXPECT_NEAR(gun().energy, rules_.charge * (1 + 2 * std::min(share, 1.0)), 1e-9) << share;
  }
}

TEST_F(GunTest, uses_more_energy_for_a_wider_beam) {
  double before = 2;
  for (const uint8_t width : {uint8_t{0}, uint8_t{50}, uint8_t{100}}) {
    gun().energy = 1;
    lone_.vehicle.controls.width = width;
    trigger_for(1, true);
    EXPECT_LT(gun().energy, before);
    before = gun().energy;
    EXPECT_NEAR(gun().radius, rules_.radius.low + 0.01 * width * (rules_.radius.high - rules_.radius.low),
                1e-12);
  }
}

TEST_F(GunTest, fires_until_empty_and_restarts_at_a_twentieth) {
  rules_.heating = 0;
  gun().energy = 0.2;
  trigger_for(5, true);
  EXPECT_LT(gun().energy, 0.06) << "it is switched off and on again";
  gun().firing = false;
  gun().energy = 0.04;
  lone_.vehicle.controls.fire = true;
  trigger(lone_.vehicle, speed_, rules_);
  EXPECT_FALSE(gun().firing);
  gun().energy = 0.06;
  trigger(lone_.vehicle, speed_, rules_);
  EXPECT_TRUE(gun().firing);
}

TEST_F(GunTest, reports_overheating_once_and_fires_again_after_cooling) {
  rules_.drain = 0;
  lone_.vehicle.controls.width = 50;
  gun().last = Pose{};
  EXPECT_TRUE(trigger_for(1.1 / rules_.heating, true));
  EXPECT_TRUE(gun().overheated);
  EXPECT_FALSE(gun().last) << "a beam that is off has no last pose";
  const double until_cool = (1 - rules_.cooled) / rules_.cooling;
  EXPECT_FALSE(trigger_for(0.8 * until_cool, true));
  EXPECT_FALSE(gun().firing);
  trigger_for(0.3 * until_cool, true);
  EXPECT_TRUE(gun().firing);
}

}  // namespace
}  // namespace kerf
