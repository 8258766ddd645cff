#include "core/world/world.h"

#include <gtest/gtest.h>

#include "tests/support/energy.h"
#include "tests/support/made_meshes.h"
#include "tests/support/same_world.h"
#include "tests/support/strokes.h"

namespace kerf::test {
namespace {

// A plate with one hot face.
World hot_world() {
  World world = world_of(grid(10, 0.1));
  Body& body = only_body(world);
  body.heat.set_energy(body.mesh, FaceId(90), 40);
  return world;
}

double stored(World& world) { return only_body(world).heat.stored(only_body(world).mesh); }

TEST(HeatFlow, spreads_and_records_losses_in_the_ledger) {
  World world = hot_world();
  EXPECT_TRUE(is_hot(world));
  const double before = stored(world), peak = hottest(world);
  step_heat(world, 0.5);
  EXPECT_LT(hottest(world), peak);
  EXPECT_LT(stored(world), before);
  EXPECT_NEAR(stored(world) + world.energy().lost, before, 1e-6 * before);
}

TEST(HeatFlow, converges_to_ambient) {
  World world = hot_world();
  for (int i = 0; i < 400; ++i) step_heat(world, 10);
  EXPECT_NEAR(hottest(world), kAmbient, 0.5);
}

TEST(HeatFlow, is_zero_without_hot_faces) {
  World world = world_of(grid(4, 0.1));
  EXPECT_FALSE(is_hot(world));
  step_heat(world, 10);
  EXPECT_EQ(stored(world), 0);
}

TEST(HeatFlow, does_not_depend_on_the_grouping_of_ticks) {
  World batched = hot_world(), one_by_one = hot_world();
  const auto pass = [](World& world, Ticks ticks) {
    world.pass(ticks);
    cool_for_ticks(world, ticks);
  };
  pass(batched, 60);
  for (int i = 0; i < 60; ++i) pass(one_by_one, 1);
  expect_same_world(batched, one_by_one);
  EXPECT_EQ(stored(batched), stored(one_by_one));
  EXPECT_EQ(batched.energy().lost, one_by_one.energy().lost);
  World three = hot_world();
  pass(three, 3);
  EXPECT_EQ(stored(three), 40) << "it flows each fourth tick";
}

TEST(HeatFlow, of_many_ticks_equals_single_flows_in_bodies_of_different_shape) {
  World batched = hot_world();
  Body second = make_body("sphere", build(sphere(8, 16, 0.1)));
  second.heat.set_energy(second.mesh, FaceId(90), 70);
  batched.add(std::move(second));
  World single = batched;
  batched.pass(60);
  single.pass(60);
  cool_for_ticks(batched, 60);
  for (int i = 0; i < 15; ++i) cool(single, static_cast<double>(kTicksOfFlow) / kTicksPerSecond);
  expect_same_world(batched, single);
  EXPECT_EQ(batched.energy().lost, single.energy().lost);
}

}  // namespace
}  // namespace kerf::test
