#include "core/game/vehicle/vehicle.h"

#include <gtest/gtest.h>

#include "tests/support/game_files.h"

namespace kerf {
namespace {

using test::LoneVehicle;
using Indices = std::vector<size_t>;

const Vec3 kDown(0, -1, 0), kRight(-1, 0, 0);

TEST(Damage, is_zero_for_an_intact_vehicle) {
  LoneVehicle lone;
  const Damage damage = assess_damage(lone.world, lone.vehicle);
  EXPECT_TRUE(damage.wheels.empty() && damage.vitals.empty());
  EXPECT_FALSE(damage.turret || damage.barrel || damage.died);
  EXPECT_TRUE(lone.vehicle.alive && lone.vehicle.gun.works());
  EXPECT_NEAR(lone.vehicle.whole, 1, 1e-9);
}

TEST(Damage, a_wheel_comes_off_when_its_axle_is_cut_between_hub_and_body) {
  LoneVehicle lone;
  lone.cut({{0.655, 0.8, 0.8}, kDown}, {{0.655, 0.8, 1.8}, kDown}, 0.01, 1);
  const Damage damage = assess_damage(lone.world, lone.vehicle);
  EXPECT_EQ(damage.wheels, Indices{0});
  EXPECT_EQ(lone.vehicle.wheels_attached(), 3u);
  EXPECT_FALSE(lone.vehicle.has(lone.vehicle.wheels[0].body));
  EXPECT_TRUE(lone.world.contains(lone.vehicle.wheels[0].body));
  EXPECT_TRUE(lone.vehicle.alive);
}

TEST(Damage, a_wheel_with_a_burnt_hub_is_lost) {
  LoneVehicle lone;
  lone.cut({{1.2, 0.32, -1.3}, kRight}, {{1.2, 0.32, -1.29}, kRight}, 0.16, 0.5);
  EXPECT_EQ(assess_damage(lone.world, lone.vehicle).wheels, Indices{2});
}

TEST(Damage, a_wheel_with_a_damaged_tyre_still_works) {
  LoneVehicle lone;
  lone.cut({{1.2, 0.05, -1.3}, kRight}, {{1.2, 0.06, -1.3}, kRight}, 0.05, 0.5);
  EXPECT_TRUE(assess_damage(lone.world, lone.vehicle).wheels.empty());
}

TEST(Damage, a_turret_cut_off_its_mount_cannot_fire) {
  LoneVehicle lone;
  lone.cut({{1, 1.445, -0.8}, kRight}, {{1, 1.445, 0.4}, kRight}, 0.015, 3);
  const Damage damage = assess_damage(lone.world, lone.vehicle);
  EXPECT_TRUE(damage.turret && damage.barrel);
  EXPECT_FALSE(lone.vehicle.gun.works());
  EXPECT_TRUE(lone.vehicle.alive);
}

TEST(Damage, a_vehicle_without_an_engine_is_dead) {
  LoneVehicle lone;
  lone.cut({{1.5, 0.42, 1.4}, kRight}, {{1.5, 0.44, 1.4}, kRight}, 0.3, 3);
  const Damage damage = assess_damage(lone.world, lone.vehicle);
  EXPECT_EQ(damage.vitals, Indices{0});
  EXPECT_TRUE(damage.died);
  EXPECT_FALSE(lone.vehicle.alive);
  EXPECT_FALSE(assess_damage(lone.world, lone.vehicle).died) << "it dies once";
}

TEST(Damage, a_vehicle_without_its_driver_is_dead) {
  LoneVehicle lone;
  lone.cut({{0.36, 2, -0.25}, kDown}, {{0.36, 2, -0.2}, kDown}, 0.4, 2);
  EXPECT_EQ(assess_damage(lone.world, lone.vehicle).vitals, Indices{1});
}

TEST(Damage, a_vehicle_cut_in_half_is_dead) {
  LoneVehicle lone;
  lone.cut({{2, -0.1, 0.72}, kRight}, {{2, 2, 0.72}, kRight}, 0.02, 4);
  const Damage damage = assess_damage(lone.world, lone.vehicle);
  EXPECT_TRUE(damage.died);
  EXPECT_LT(lone.vehicle.whole, 0.8);
}

}  // namespace
}  // namespace kerf
