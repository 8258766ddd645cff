#include "ui/render/view/camera.h"

#include <gtest/gtest.h>

#include "tests/support/made_meshes.h"
#include "tests/ui/render/shadow_scenes.h"

namespace kerf {
namespace {

constexpr double kEarth = 9.81;

TEST(DrawnGround, bodies_fall_in_file_units_against_the_up_axis) {
  World world = test::world_of_all({test::sphere(6, 8, 50)});
  FileFrame frame;
  frame.unit = FileUnit::kMillimetre;
  frame.up = UpAxis::kZ;
  const Environment first = fitting_environment(world, frame);
  EXPECT_NEAR(first.gravity.z, -1000 * kEarth, 1e-9);
  EXPECT_NEAR(first.metre, 1000, 1e-9);
  ASSERT_TRUE(first.ground);
  EXPECT_LT(*first.ground, -49);
  world.set_environment(first);
  EXPECT_EQ(fitting_environment(world, frame), first);
}

TEST(DrawnGround, custom_gravity_keeps_its_value_in_metres_when_the_unit_changes) {
  World world = test::world_of_all({test::sphere(6, 8, 50)});
  FileFrame frame;
  world.set_environment({.gravity = {0, -1.62, 0}, .ground = -60});
  EXPECT_EQ(fitting_environment(world, frame), world.environment());
  frame.unit = FileUnit::kMillimetre;
  const Environment moon = fitting_environment(world, frame);
  EXPECT_NEAR(moon.gravity.y, -1620, 1e-9);
  EXPECT_EQ(moon.ground, -60);
}

TEST(DrawnGround, lengths_of_contact_follow_the_unit_without_gravity) {
  World world = test::world_of_all({test::sphere(6, 8, 50)});
  FileFrame frame;
  world.set_environment({.gravity = Vec3(0), .ground = std::nullopt});
  EXPECT_EQ(fitting_environment(world, frame), world.environment());
  frame.unit = FileUnit::kMillimetre;
  const Environment floating = fitting_environment(world, frame);
  EXPECT_EQ(floating.gravity, Vec3(0));
  EXPECT_FALSE(floating.ground);
  EXPECT_NEAR(floating.metre, 1000, 1e-9);
}

}  // namespace
}  // namespace kerf
