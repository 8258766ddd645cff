#include "core/game/vehicle/vehicle_dynamics.h"

#include <gtest/gtest.h>

#include "core/base/deterministic_math.h"
#include "tests/support/made_meshes.h"
#include "tests/support/sheets.h"

namespace kerf {
namespace {

// A turned plate of two metres by one that moves and spins.
Body moving_plate() {
  Body body = make_body("plate", test::build(test::rectangle(2, 1, 4)));
  body.placement = {{3, 1, -2}, axis_angle({1, 0, 0}, 0.4)};
  body.motion.velocity = {1, 2, 3};
  body.motion.spin = {0.3, -0.2, 0.5};
  return body;
}

const Vec3 kPoint(3.4, 1.1, -1.8), kAlong(0, 0.6, 0.8);

TEST(RigidMotion, has_the_mass_centre_and_velocity_of_its_body) {
  const Body body = moving_plate();
  const RigidMotion motion(body);
  EXPECT_NEAR(motion.mass(), 2 * 0.001 * 7850, 1e-9);
  EXPECT_NEAR(glm::distance(motion.centre(), body.placement.position), 0, 1e-9);
  EXPECT_NEAR(glm::distance(motion.velocity_at(kPoint), body.motion.velocity_at(kPoint, body.placement)), 0,
              1e-9);
}

TEST(RigidMotion, store_and_load_round_trip) {
  Body body = moving_plate();
  const Motion before = body.motion;
  RigidMotion(body).store(body);
  EXPECT_NEAR(glm::distance(body.motion.velocity, before.velocity), 0, 1e-12);
  EXPECT_EQ(body.motion.spin, before.spin);
}

TEST(RigidMotion, responds_to_an_impulse_by_its_effective_mass) {
  const Body body = moving_plate();
  RigidMotion motion(body);
  const double before = glm::dot(motion.velocity_at(kPoint), kAlong),
               response = motion.response(kPoint, kAlong);
  motion.push(kPoint, 5.0 * kAlong);
  EXPECT_NEAR(glm::dot(motion.velocity_at(kPoint), kAlong) - before, 5 * response, 1e-9);
  EXPECT_GT(response, 1 / motion.mass()) << "a point beside the centre gives way more";
  EXPECT_NEAR(motion.response(motion.centre(), kAlong), 1 / motion.mass(), 1e-12);
}

TEST(RigidMotion, does_not_spin_when_pushed_at_its_centre) {
  const Body body = moving_plate();
  RigidMotion aside(body), centred(body);
  centred.push({0, 4, 0});
  aside.push(kPoint, {0, 4, 0});
  EXPECT_EQ(centred.spin(), body.motion.spin);
  EXPECT_EQ(centred.velocity(), aside.velocity()) << "the centre moves alike";
  EXPECT_NE(aside.spin(), body.motion.spin);
}

// A thin plate of the sides a and b about its middle: m b^2 / 12, m a^2 / 12 and their sum.
TEST(RigidMotion, spins_by_the_inertia_of_a_plate) {
  Body body = make_body("plate", test::build(test::rectangle(2, 1, 4)));
  RigidMotion motion(body);
  motion.push({1, 0, 0}, {0, 1, 0});
  EXPECT_NEAR(motion.spin().z, 1 / (motion.mass() * 4 / 12), 1e-6);
  motion = RigidMotion(body);
  motion.push({1, 0, 0}, {0, 0, 1});
  EXPECT_NEAR(motion.spin().y, -1 / (motion.mass() * 5 / 12), 1e-6);
}

}  // namespace
}  // namespace kerf
