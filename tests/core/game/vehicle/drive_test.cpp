#include "core/game/vehicle/vehicle_dynamics.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "core/base/deterministic_math.h"
#include "core/base/ids.h"
#include "core/game/match/match.h"
#include "core/game/vehicle/vehicle.h"
#include "core/physics/physics.h"
#include "tests/support/game_files.h"
#include "tests/support/sheets.h"

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

TEST_F(Driving, an_idle_vehicle_stands_on_its_wheels) {
  drive(0, 0, 2);
  EXPECT_LT(glm::length(chassis().motion.velocity), 0.02);
  EXPECT_NEAR(position().y, 0, 0.03);
  EXPECT_GT(axis({0, 1, 0}).y, 0.9999);
  for (const Wheel& wheel : match_.vehicles()[0].wheels) EXPECT_TRUE(wheel.grounded);
}

TEST_F(Driving, throttle_drives_straight_forward_and_backward) {
  drive(100, 0, 4);
  EXPECT_GT(speed(), 10);
  EXPECT_GT(position().z, 15);
  EXPECT_NEAR(position().x, 0, 0.3);
  EXPECT_GT(axis({0, 1, 0}).y, 0.99);
  drive(-100, 0, 8);
  EXPECT_LT(speed(), -2);
}

TEST_F(Driving, brakes_stop_the_vehicle_without_reversing) {
  drive(100, 0, 3);
  const double fast = speed(), before = position().z;
  drive(0, 0, 3, true);
  EXPECT_NEAR(speed(), 0, 0.1);
  EXPECT_LT(position().z - before, fast * fast / (2 * 5));
}

TEST_F(Driving, steering_left_turns_left_without_rolling_over) {
  drive(100, 0, 2);
  drive(60, 100, 2);
  EXPECT_GT(heading_of(axis({0, 0, 1})), 0.5);
  EXPECT_GT(position().x, 1);
  EXPECT_GT(axis({0, 1, 0}).y, 0.97);
}

TEST_F(Driving, the_vehicle_does_not_leave_the_arena) {
  drive(100, 0, 12);
  EXPECT_LT(position().z, 100);
}

constexpr double kGravity = 9.81;  // m/s^2

// A vehicle on its wheels, as they carry its weight.
class Wheels : public testing::Test {
 protected:
  double weight() const { return lone_.vehicle.what().mass * kGravity; }
  Vec3 momentum(BodyId id) const {
    const RigidMotion motion(lone_.world.body(id));
    return motion.mass() * motion.velocity();
  }
  // The bodies that move by themselves.
  std::vector<BodyId> free_bodies() const {
    const std::vector<BodyId> carried = carried_bodies(lone_.vehicle);
    std::vector<BodyId> ids = lone_.world.ids();
    std::erase_if(ids, [&](BodyId id) { return std::count(carried.begin(), carried.end(), id) > 0; });
    return ids;
  }
  Vec3 momentum() const {
    Vec3 sum(0);
    for (const BodyId id : free_bodies()) sum += momentum(id);
    return sum;
  }
  double mass() const {
    double sum = 0;
    for (const BodyId id : free_bodies()) sum += RigidMotion(lone_.world.body(id)).mass();
    return sum;
  }
  // The force upwards that its wheels put on it, N.
  double lift() {
    const double before = momentum(lone_.vehicle.chassis).y;
    drive(lone_.world, lone_.vehicle, Sight(lone_.world));
    return (momentum(lone_.vehicle.chassis).y - before) / kTick;
  }
  // Cuts a wheel off its axle, and leaves it where it is.
  void lose_wheel(size_t wheel) {
    const Vec3 hub = lone_.vehicle.what().wheels[wheel].hub;
    const double x = hub.x > 0 ? hub.x - 0.083 : hub.x + 0.083;
    const Vec3 down(0, -1, 0);
    lone_.cut({{x, 0.8, hub.z - 0.5}, down}, {{x, 0.8, hub.z + 0.5}, down}, 0.01, 1);
    ASSERT_EQ(assess_damage(lone_.world, lone_.vehicle).wheels, std::vector<size_t>{wheel});
  }
  void lift_all(double height) {
    for (const BodyId id : lone_.world.ids()) lone_.world.body(id).placement.position.y += height;
  }
  // A sheet of a mass, level at a place.
  BodyId add_sheet(double mass, double size, const Vec3& place) {
    const BodyId id = test::add(lone_.world, test::rectangle(size, size, 2), place);
    Body& body = lone_.world.body(id);
    body.sheet.density = mass / (size * size * body.sheet.thickness);
    return id;
  }

  test::LoneVehicle lone_;
};

TEST_F(Wheels, carry_the_weight_at_rest) { EXPECT_NEAR(lift(), weight(), 0.01 * weight()); }

TEST_F(Wheels, lost_in_the_arch_lift_nothing) {
  for (size_t wheel = 0; wheel < 4; ++wheel) {
    lone_ = test::LoneVehicle();
    lose_wheel(wheel);
    EXPECT_LE(lift(), 0.76 * weight()) << "wheel " << wheel;
  }
}

TEST_F(Wheels, are_not_lifted_by_light_debris_under_the_chassis) {
  add_sheet(40, 0.4, lone_.vehicle.what().wheels[1].hub + Vec3(0, 0.2, 0));
  EXPECT_NEAR(lift(), weight(), 0.01 * weight());
}

TEST_F(Wheels, push_back_on_the_bodies_that_carry_them) {
  const BodyId plate = add_sheet(800, 8, {0, 20 - 0.02, 0});
  lift_all(20);
  lone_.world.body(plate).placement.position.y -= 20;
  lone_.vehicle.controls.throttle = 100;
  drive(lone_.world, lone_.vehicle, Sight(lone_.world));
  const Vec3 vehicle = momentum(lone_.vehicle.chassis), pushed = momentum(plate);
  EXPECT_GT(vehicle.y, 0.1 * weight() * kTick);
  EXPECT_GT(vehicle.z, 1);
  EXPECT_LT(glm::length(vehicle + pushed), 1e-6 * glm::length(vehicle));
}

TEST_F(Wheels, lost_in_the_air_transfer_no_momentum) {
  for (size_t wheel = 0; wheel < 4; ++wheel) {
    SCOPED_TRACE(wheel);
    lone_ = test::LoneVehicle();
    lose_wheel(wheel);
    lift_all(50);
    const Vec3 before = momentum();
    drive(lone_.world, lone_.vehicle, Sight(lone_.world));
    for (const BodyId id : carried_bodies(lone_.vehicle)) lone_.world.body(id).hidden = true;
    Physics().tick(lone_.world);
    const Vec3 change = momentum() - before, gained = mass() * kTick * Vec3(0, -kGravity, 0);
    EXPECT_LT(glm::length(change - gained), 0.01 * glm::length(gained));
  }
}

}  // namespace
}  // namespace kerf
