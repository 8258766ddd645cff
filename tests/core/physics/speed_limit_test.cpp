#include "core/physics/motion_limits.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/core/physics/moving_sheets.h"
#include "tests/support/sheets.h"

namespace kerf {
namespace {

// A slow plate and a fast one.
class TwoPlates : public testing::Test {
 protected:
  TwoPlates() {
    sheets_.add(test::rectangle(1, 1, 1), {0, 0, 0});
    sheets_.add(test::rectangle(1, 1, 1), {3, 0, 0});
    sheets_.body(0).motion.velocity = {1, 0, 0};
    sheets_.body(1).motion.velocity = {0, 5, 0};
  }
  // The speed of the first plate after a tick that would have shot it.
  double shot(bool touching, bool joined = false, double gain = 0.2) {
    std::vector<MovingBody>& bodies = sheets_.bodies();
    std::vector<TouchingPair> pairs;
    if (touching) pairs.push_back({0, 1, {Contact{}}, {}});
    const Joint joint{};
    const std::vector<BodyJoint> joints(joined ? 1 : 0, BodyJoint{0, 1, &joint});
    const SpeedLimit limit(bodies, pairs, joints, gain);
    sheets_.body(0).motion.velocity = {1000, 0, 0};
    limit.apply(bodies);
    return glm::length(sheets_.body(0).motion.velocity);
  }

  test::MovingSheets sheets_;
};

TEST_F(TwoPlates, gain_only_a_little_speed_when_apart) { EXPECT_NEAR(shot(false), 1.2, 1e-9); }

TEST_F(TwoPlates, gain_speed_up_to_the_faster_touching_or_jointed_body) {
  EXPECT_NEAR(shot(true), 5.2, 1e-9);
  sheets_.body(0).motion.velocity = {1, 0, 0};
  EXPECT_NEAR(shot(false, true), 5.2, 1e-9);
}

TEST_F(TwoPlates, never_exceed_300_metres_per_second) { EXPECT_NEAR(shot(false, false, 1e4), 300, 1e-9); }

TEST_F(TwoPlates, keep_an_allowed_motion) {
  std::vector<MovingBody>& bodies = sheets_.bodies();
  const SpeedLimit limit(bodies, {}, {}, 0.1);
  sheets_.body(0).motion.velocity = {0.5, 0.5, 0};
  sheets_.body(0).motion.spin = {0, 1, 0};
  limit.apply(bodies);
  EXPECT_NEAR(glm::distance(sheets_.body(0).motion.velocity, Vec3(0.5, 0.5, 0)), 0, 1e-12);
  EXPECT_EQ(sheets_.body(0).motion.spin, Vec3(0, 1, 0));
}

TEST_F(TwoPlates, spin_no_faster_than_the_speed_limit_at_their_edges) {
  std::vector<MovingBody>& bodies = sheets_.bodies();
  const SpeedLimit limit(bodies, {}, {}, 0);
  sheets_.body(0).motion.spin = {0, 1e6, 0};
  limit.apply(bodies);
  EXPECT_NEAR(sheets_.body(0).motion.spin.y, 2 * 1 / std::sqrt(0.5), 1e-9);
}

TEST_F(TwoPlates, are_limited_after_a_pinned_one) {
  sheets_.body(0).pinned = true;
  std::vector<MovingBody>& bodies = sheets_.bodies();
  const SpeedLimit limit(bodies, {}, {}, 0.2);
  sheets_.body(1).motion.velocity = {0, 1000, 0};
  limit.apply(bodies);
  EXPECT_NEAR(glm::length(sheets_.body(1).motion.velocity), 5.2, 1e-9);
}

}  // namespace
}  // namespace kerf
