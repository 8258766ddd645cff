
#include <gtest/gtest.h>

#include <algorithm>

#include "core/base/deterministic_math.h"
#include "core/game/driver/steering.h"
#include "tests/support/game_files.h"
#include "tests/support/sheets.h"

namespace kerf {
namespace {

TEST(Traffic, excludes_pinned_hidden_small_and_flat_bodies) {
  World world;
  const Soup box = test::closed_box({1, 1, 1});
  world.body(test::add(world, box, Vec3(0))).pinned = true;
  world.body(test::add(world, box, Vec3(5, 0, 0))).hidden = true;
  test::add(world, test::closed_box({0.3, 0.3, 0.3}), {10, 0, 0});
  test::add(world, test::rectangle(3, 3, 2), {15, 0, 0});
  EXPECT_TRUE(find_traffic(world, {}).empty());
  const BodyId upright =
      test::add(world, test::rectangle(3, 3, 2), {20, 0, 0}, axis_angle({1, 0, 0}, kPi / 2));
  const std::vector<Disc> discs = find_traffic(world, {});
  ASSERT_FALSE(discs.empty());
  for (const Disc& disc : discs) EXPECT_EQ(disc.body, upright);
}

// How far a point lies from the discs that cover it, seen from above; at most 0 within one.
double outside(const std::vector<Disc>& discs, const Vec3& p) {
  double least = 1e9;
  for (const Disc& disc : discs) {
    const Vec3 way = p - disc.centre;
    least = std::min(least, glm::length(Vec2(way.x, way.z)) - disc.radius);
  }
  return least;
}

TEST(Traffic, covers_a_long_body_tightly_with_several_discs) {
  World world;
  const BodyId beam =
      test::add(world, test::closed_box({0.6, 0.6, 4}), {2, 0.3, 1}, axis_angle({0, 1, 0}, 0.7));
  world.body(beam).motion.velocity = {1, 0, 2};
  const std::vector<Disc> discs = find_traffic(world, {});
  EXPECT_GE(discs.size(), 4u);
  for (const double along : {-2.0, -1.0, 0.0, 0.5, 2.0})
    EXPECT_LT(outside(discs, world.body(beam).placement.to_world({0, 0, along})), 0.01) << along;
  for (const Disc& disc : discs) {
    EXPECT_EQ(disc.velocity, Vec3(1, 0, 2));
    EXPECT_NEAR(disc.radius, 0.3, 1e-6);
  }
  EXPECT_GT(outside(discs, world.body(beam).placement.to_world({0, 0, 2.5})), 0.3);
}

// A sign on a column, four metres above the ground: a vehicle drives through below it.
TEST(Traffic, of_a_tall_body_covers_only_the_height_of_a_vehicle) {
  Soup sign = test::closed_box({0.3, 5, 0.3});
  const Soup board = test::closed_box({4, 1, 0.1});
  const auto first = static_cast<uint32_t>(sign.positions.size());
  for (const Vec3& p : board.positions) sign.positions.push_back(p + Vec3(2, 2, 0));
  for (Soup::Triangle t : board.triangles) {
    for (uint32_t& corner : t) corner += first;
    sign.triangles.push_back(t);
  }
  World world;
  test::add(world, sign, {0, 2.5, 0});
  const std::vector<Disc> discs = find_traffic(world, {});
  ASSERT_FALSE(discs.empty());
  EXPECT_LT(outside(discs, {0, 0, 0}), 0);
  EXPECT_GT(outside(discs, {2, 0, 0}), 1.5);
}

TEST(Traffic, of_a_vehicle_is_only_its_chassis) {
  test::LoneVehicle lone;
  const std::vector<Disc> discs = find_traffic(lone.world, {&lone.vehicle, 1});
  ASSERT_FALSE(discs.empty());
  for (const Disc& disc : discs) EXPECT_EQ(disc.body, lone.vehicle.chassis);
  lone.vehicle.wheels[0].attached = false;
  const std::vector<Disc> with_wheel = find_traffic(lone.world, {&lone.vehicle, 1});
  ASSERT_GT(with_wheel.size(), discs.size()) << "a wheel that came off lies on the way";
  EXPECT_TRUE(std::any_of(with_wheel.begin(), with_wheel.end(),
                          [&](const Disc& disc) { return disc.body == lone.vehicle.wheels[0].body; }));
}

}  // namespace
}  // namespace kerf
