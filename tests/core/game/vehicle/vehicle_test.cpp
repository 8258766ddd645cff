#include "core/game/vehicle/vehicle.h"

#include <gtest/gtest.h>

#include "tests/support/game_files.h"
#include "tests/support/sheets.h"

namespace kerf {
namespace {

TEST(Vehicle, owns_its_bodies_until_they_come_off) {
  test::LoneVehicle lone;
  Vehicle& v = lone.vehicle;
  for (const BodyId id : lone.world.ids()) EXPECT_TRUE(v.has(id));
  const BodyId sheet = test::add(lone.world, test::rectangle(1, 1, 1), {0, 0, 9});
  EXPECT_FALSE(v.has(sheet));
  v.wheels[1].attached = false;
  EXPECT_FALSE(v.has(v.wheels[1].body));
  EXPECT_TRUE(v.has(v.wheels[0].body));
  v.gun.turret_attached = false;
  EXPECT_FALSE(v.has(v.gun.turret) || v.has(v.gun.barrel)) << "the barrel goes with the turret";
}

TEST(Vehicle, recognises_its_bodies_after_they_come_off) {
  test::LoneVehicle lone;
  lone.vehicle.wheels[1].attached = false;
  for (const BodyId id : lone.world.ids()) EXPECT_TRUE(lone.vehicle.is_made_of(lone.world.body(id)));
  const BodyId sheet = test::add(lone.world, test::rectangle(1, 1, 1), {0, 0, 9});
  EXPECT_FALSE(lone.vehicle.is_made_of(lone.world.body(sheet)));
}

TEST(Vehicle, can_drive_while_a_driven_wheel_is_attached) {
  test::LoneVehicle lone;
  Vehicle& v = lone.vehicle;
  EXPECT_EQ(v.wheels_attached(), 4u);
  size_t driven = 0;
  for (size_t i = 0; i < v.wheels.size(); ++i) driven += v.what().wheels[i].driven;
  ASSERT_GT(driven, 0u);
  for (size_t i = 0; i < v.wheels.size(); ++i) {
    EXPECT_TRUE(v.can_drive());
    if (!v.what().wheels[i].driven) continue;
    v.wheels[i].attached = false;
    if (--driven == 0) break;
  }
  EXPECT_FALSE(v.can_drive());
}

TEST(Vehicle, fires_only_with_turret_and_barrel) {
  Gun gun;
  EXPECT_TRUE(gun.works());
  gun.barrel_attached = false;
  EXPECT_FALSE(gun.works());
  gun = Gun();
  gun.turret_attached = false;
  EXPECT_FALSE(gun.works());
}

}  // namespace
}  // namespace kerf
