#include "core/game/vehicle/vehicle.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "core/base/deterministic_math.h"
#include "tests/support/game_files.h"

namespace kerf {
namespace {

// A vehicle that was put somewhere else, turned, and moves.
class CarriedBodies : public testing::Test {
 protected:
  CarriedBodies() {
    chassis().placement = {{4, 1, -3}, axis_angle({0, 1, 0}, 0.8) * axis_angle({1, 0, 0}, 0.1)};
    chassis().motion.velocity = {2, 0, 5};
    chassis().motion.spin = {0, 0.7, 0};
  }
  Body& chassis() { return lone_.world.body(lone_.vehicle.chassis); }
  const Body& wheel(size_t i) { return lone_.world.body(lone_.vehicle.wheels[i].body); }
  Vec3 hub(size_t i) { return lone_.vehicle.what().wheels[i].hub; }
  void place() { place_carried(lone_.world, lone_.vehicle); }

  test::LoneVehicle lone_;
};

TEST_F(CarriedBodies, follow_the_chassis) {
  place();
  for (const BodyId id : carried_bodies(lone_.vehicle)) {
    const Vec3 there = lone_.world.body(id).placement.to_world({0.3, 0.5, 0.7});
    EXPECT_NEAR(glm::distance(there, chassis().placement.to_world({0.3, 0.5, 0.7})), 0, 1e-9);
    EXPECT_NEAR(glm::distance(in_world(lone_.world, lone_.vehicle, {0.3, 0.5, 0.7}), there), 0, 1e-9);
  }
}

TEST_F(CarriedBodies, wheels_turn_about_their_hubs_and_rise_with_the_suspension) {
  lone_.vehicle.wheels[0].steer = 0.4;
  lone_.vehicle.wheels[0].angle = 1.1;
  lone_.vehicle.wheels[0].rise = 0.07;
  place();
  const Vec3 risen = chassis().placement.to_world(hub(0) + Vec3(0, 0.07, 0));
  EXPECT_NEAR(glm::distance(wheel(0).placement.to_world(hub(0)), risen), 0, 1e-9);
  // The axle of a wheel that is steered to the left points backwards on the left.
  const Vec3 axle =
      glm::conjugate(chassis().placement.orientation) * wheel(0).placement.orientation * Vec3(1, 0, 0);
  EXPECT_NEAR(axle.x, sin_cos(0.4).cos, 1e-9);
  EXPECT_NEAR(axle.z, -sin_cos(0.4).sin, 1e-9);
}

TEST_F(CarriedBodies, move_with_the_chassis_and_wheels_also_roll) {
  lone_.vehicle.wheels[1].rate = 30;
  place();
  const Body& turret = lone_.world.body(lone_.vehicle.gun.turret);
  const Vec3 p = turret.placement.to_world({0, 1.5, 0});
  EXPECT_NEAR(glm::distance(turret.motion.velocity_at(p, turret.placement),
                            chassis().motion.velocity_at(p, chassis().placement)),
              0, 1e-9);
  const Vec3 middle = wheel(1).placement.to_world(hub(1));
  EXPECT_NEAR(glm::distance(wheel(1).motion.velocity_at(middle, wheel(1).placement),
                            chassis().motion.velocity_at(middle, chassis().placement)),
              0, 1e-9);
  const Vec3 axle = chassis().placement.orientation * Vec3(1, 0, 0);
  EXPECT_NEAR(glm::dot(wheel(1).motion.spin - chassis().motion.spin, axle), 30, 1e-9);
}

TEST_F(CarriedBodies, turret_and_barrel_aim_the_beam) {
  chassis().placement = Placement{};
  lone_.vehicle.gun.yaw = 0.5;
  lone_.vehicle.gun.pitch = 0.3;
  place();
  const Pose beam = muzzle_pose(lone_.world, lone_.vehicle);
  EXPECT_NEAR(glm::distance(beam.direction, direction_of(0.5, 0.3)), 0, 1e-9);
  const TurretDescription& turret = lone_.vehicle.what().turret;
  const Vec3 pivot = turret.pivot + axis_angle({0, 1, 0}, 0.5) * (turret.barrel.pivot - turret.pivot);
  EXPECT_NEAR(glm::distance(beam.origin, pivot), glm::distance(turret.barrel.muzzle, turret.barrel.pivot),
              1e-9);
}

TEST_F(CarriedBodies, stay_in_place_after_they_come_off) {
  const size_t all = all_bodies(lone_.vehicle).size();
  EXPECT_EQ(all, lone_.world.ids().size());
  lone_.vehicle.wheels[2].attached = false;
  lone_.vehicle.gun.turret_attached = false;
  const Placement before = wheel(2).placement;
  place();
  EXPECT_EQ(wheel(2).placement, before);
  const std::vector<BodyId> carried = carried_bodies(lone_.vehicle);
  EXPECT_EQ(carried.size(), 3u);
  EXPECT_EQ(std::count(carried.begin(), carried.end(), lone_.vehicle.gun.barrel), 0);
  EXPECT_EQ(all_bodies(lone_.vehicle).back(), lone_.vehicle.chassis);
}

}  // namespace
}  // namespace kerf
