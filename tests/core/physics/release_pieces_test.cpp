#include "core/physics/physics.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/edit/separation.h"
#include "core/physics/contact/rigid_body.h"
#include "tests/support/sheets.h"
#include "tests/support/strokes.h"

namespace kerf {
namespace {

// A plate of two metres that was cut across and moves.
class CutPlate : public testing::Test {
 protected:
  CutPlate() {
    plate_ = test::add(world_, test::rectangle(2, 1, 10), {0, 1, 0});
    CutSettings settings;
    settings.laser.radius = 0.02;
    settings.resolution.target_edge = 0.05;
    const Vec3 down(0, -1, 0);
    const std::vector<BeamMove> moves = subdivide({{{0.3, 2, -1}, down}, {{0.3, 2, 1}, down}}, 0.02, 5);
    EXPECT_TRUE(test::cut_whole(world_, settings, moves));
    settle(world_.body(plate_));
    world_.body(plate_).motion.velocity = {1, 2, 3};
    world_.body(plate_).motion.spin = {0, 0.5, 0};
  }
  std::vector<BodyId> release() {
    release_pieces(world_, 9, delta_);
    return world_.ids();
  }
  // kg m/s
  Vec3 momentum() const {
    Vec3 sum(0);
    for (const BodyId id : world_.ids()) {
      const Body& body = world_.body(id);
      const RigidFrame frame = rigid_frame(body);
      sum += frame.mass * body.motion.velocity_at(body.placement.to_world(frame.centre), body.placement);
    }
    return sum;
  }

  World world_;
  BodyId plate_;
  Delta delta_;
};

TEST_F(CutPlate, falls_as_two_bodies_that_keep_their_momentum) {
  EXPECT_TRUE(has_pieces_off(world_.body(plate_)));
  const Vec3 before = momentum();
  const std::vector<BodyId> ids = release();
  ASSERT_EQ(ids.size(), 2u);
  EXPECT_EQ(delta_.detached.size(), 1u);
  EXPECT_FALSE(has_pieces_off(world_.body(ids[0])) || has_pieces_off(world_.body(ids[1])));
  EXPECT_NEAR(glm::distance(momentum(), before), 0, 1e-9);
  for (const BodyId id : ids) EXPECT_EQ(world_.body(id).motion.spin, Vec3(0, 0.5, 0));
}

TEST_F(CutPlate, is_separated_along_the_line_between_the_centres) {
  world_.body(plate_).motion = Motion{};
  const std::vector<BodyId> ids = release();
  const Vec3 apart = world_.body(ids[1]).motion.velocity - world_.body(ids[0]).motion.velocity;
  EXPECT_NEAR(glm::length(apart), kPushApart, 1e-9);
  EXPECT_NEAR(std::abs(apart.x), kPushApart, 1e-4);
}

TEST_F(CutPlate, stays_if_pinned_and_frees_the_other_piece) {
  world_.body(plate_).motion = Motion{};
  world_.body(plate_).pinned = true;
  release();
  size_t pinned = 0;
  for (const BodyId id : world_.ids()) {
    const Body& body = world_.body(id);
    pinned += body.pinned;
    EXPECT_EQ(body.motion.velocity == Vec3(0), body.pinned);
  }
  EXPECT_EQ(pinned, 1u);
}

TEST_F(CutPlate, is_not_split_if_hidden) {
  world_.body(plate_).hidden = true;
  EXPECT_FALSE(has_pieces_off(world_.body(plate_)));
  EXPECT_EQ(release().size(), 1u);
  EXPECT_TRUE(delta_.empty());
}

}  // namespace
}  // namespace kerf
