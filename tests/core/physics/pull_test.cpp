#include "core/physics/physics.h"

#include <gtest/gtest.h>

#include "core/base/ids.h"
#include "tests/support/sheets.h"

namespace kerf {
namespace {

// A plate at rest that sleeps, and a spring at one of its points.
class PulledPlate : public testing::Test {
 protected:
  PulledPlate() {
    plate_ = test::add(world_, test::rectangle(2, 1, 4), {3, 1, 0});
    body().motion.asleep = true;
  }
  Body& body() { return world_.body(plate_); }
  void hold(const Vec3& at, const Vec3& to) { world_.set_spring(Spring{{plate_, 0}, at, to}); }
  Vec3 velocity_of(const Vec3& own) {
    return body().motion.velocity_at(body().placement.to_world(own), body().placement);
  }

  World world_;
  BodyId plate_;
};

TEST_F(PulledPlate, accelerates_the_held_point_towards_the_spring_end) {
  const Vec3 corner(0.9, 0, 0.4);
  hold(corner, body().placement.to_world(corner) + Vec3(0, 0.1, 0));
  apply_spring(world_, kTick);
  EXPECT_FALSE(body().motion.asleep);
  const double wanted = kSpringFrequency * kSpringFrequency * 0.1;
  EXPECT_NEAR(glm::distance(velocity_of(corner), Vec3(0, wanted * kTick, 0)), 0, 1e-9);
  EXPECT_GT(glm::length(body().motion.spin), 0.01) << "a corner turns the plate";
}

TEST_F(PulledPlate, has_limited_acceleration) {
  hold(Vec3(0), {3, 50, 0});
  apply_spring(world_, kTick);
  EXPECT_NEAR(body().motion.velocity.y, kMaxSpringAcceleration * kTick, 1e-9);
}

TEST_F(PulledPlate, settles_at_the_spring_end_without_overshoot) {
  hold(Vec3(0), {3, 1.5, 0});
  for (int t = 0; t < 120; ++t) {
    apply_spring(world_, kTick);
    body().placement.position += kTick * body().motion.velocity;
    ASSERT_LT(body().placement.position.y, 1.51);
  }
  EXPECT_NEAR(body().placement.position.y, 1.5, 1e-3);
  EXPECT_LT(glm::length(body().motion.velocity), 0.01);
}

TEST_F(PulledPlate, stays_in_place_if_pinned_hidden_or_not_held) {
  apply_spring(world_, kTick);
  EXPECT_TRUE(body().motion.asleep) << "there is no spring";
  hold(Vec3(0), {3, 5, 0});
  body().pinned = true;
  apply_spring(world_, kTick);
  body().pinned = false;
  body().hidden = true;
  apply_spring(world_, kTick);
  EXPECT_EQ(body().motion.velocity, Vec3(0));
  body().hidden = false;
  for (const PieceId& missing : {PieceId{BodyId{77, 0}, 0}, PieceId{plate_, 1}}) {
    world_.set_spring(Spring{missing, Vec3(0), Vec3(1)});
    apply_spring(world_, kTick);
    EXPECT_EQ(body().motion.velocity, Vec3(0));
  }
}

}  // namespace
}  // namespace kerf
