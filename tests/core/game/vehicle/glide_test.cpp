#include "core/game/vehicle/vehicle_dynamics.h"

#include <gtest/gtest.h>

#include "core/base/deterministic_math.h"
#include "tests/support/game_files.h"
#include "tests/support/made_meshes.h"
#include "tests/support/sheets.h"

namespace kerf {
namespace {

// A wall along z at x = 2, whose near side is at x = 2 - 0.1.
Obstacles wall_beside() {
  Arena arena;
  Body& wall = arena.bodies.emplace_back().body;
  wall = make_body("wall", test::build(test::closed_box({0.2, 6, 60})));
  wall.placement.position = {2, 0, 0};
  wall.pinned = true;
  return Obstacles(arena);
}

class GlideAlongWall : public testing::Test {
 protected:
  Body& chassis() { return lone_.world.body(lone_.vehicle.chassis); }
  void glide() { glide_along(lone_.world, lone_.vehicle, wall_); }

  test::LoneVehicle lone_;
  Obstacles wall_ = wall_beside();
};

TEST_F(GlideAlongWall, does_not_affect_a_vehicle_that_does_not_touch_it) {
  chassis().motion.velocity = {5, 0, 5};
  const Placement before = chassis().placement;
  glide();
  EXPECT_EQ(chassis().placement, before);
  EXPECT_EQ(chassis().motion.velocity, Vec3(5, 0, 5));
}

TEST_F(GlideAlongWall, removes_normal_velocity_and_little_tangential_velocity) {
  chassis().placement.position.x = 1.2;
  chassis().motion.velocity = {1, 0, 10};
  glide();
  EXPECT_LT(chassis().motion.velocity.x, 0.15);
  EXPECT_GT(chassis().motion.velocity.z, 9);
}

TEST_F(GlideAlongWall, moves_a_penetrating_vehicle_out) {
  chassis().placement.position.x = 1.25;
  for (int i = 0; i < 20; ++i) glide();
  EXPECT_LT(chassis().placement.position.x, 1.2);
  EXPECT_GT(chassis().placement.position.x, 0.7);
  EXPECT_EQ(chassis().placement.position.y, 0);
  const double settled = chassis().placement.position.x;
  glide();
  EXPECT_NEAR(chassis().placement.position.x, settled, 1e-3);
}

TEST_F(GlideAlongWall, applies_only_to_upright_and_awake_vehicles) {
  chassis().placement.position.x = 1.25;
  chassis().motion.asleep = true;
  glide();
  EXPECT_EQ(chassis().placement.position.x, 1.25);
  chassis().motion.asleep = false;
  chassis().placement.orientation = axis_angle({0, 0, 1}, radians_of(61));
  EXPECT_FALSE(is_upright(lone_.world, lone_.vehicle));
  glide();
  EXPECT_EQ(chassis().placement.position.x, 1.25);
  chassis().placement.orientation = axis_angle({0, 0, 1}, radians_of(59));
  EXPECT_TRUE(is_upright(lone_.world, lone_.vehicle));
}

}  // namespace
}  // namespace kerf
