#include "core/physics/motion_limits.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "core/base/random.h"
#include "tests/core/physics/moving_sheets.h"
#include "tests/support/sheets.h"

namespace kerf {
namespace {

using Pairs = std::vector<std::pair<uint32_t, uint32_t>>;

TEST(BroadPhase, finds_overlapping_pairs_with_a_moving_body_among_random_boxes) {
  Random random(4);
  test::MovingSheets sheets;
  for (int i = 0; i < 40; ++i) {
    const auto place = [&] { return random.uniform(-1.5, 1.5); };
    const uint32_t own = sheets.add(test::closed_box({0.6, 0.6, 0.6}), {place(), place(), place()});
    sheets.body(own).pinned = i % 3 == 0;
  }
  const std::vector<MovingBody>& bodies = sheets.bodies();
  const Pairs found = near_pairs(bodies);
  ASSERT_GT(found.size(), 10u);
  EXPECT_TRUE(std::is_sorted(found.begin(), found.end()));
  for (uint32_t i = 0; i < bodies.size(); ++i) {
    for (uint32_t j = i + 1; j < bodies.size(); ++j) {
      const Box &a = bodies[i].bounds, &b = bodies[j].bounds;
      const bool moves = bodies[i].moves() || bodies[j].moves();
      const bool meet = a.wider(-bodies[i].margin).overlaps(b.wider(-bodies[j].margin));
      const bool is_found = std::binary_search(found.begin(), found.end(), std::pair(i, j));
      if (moves && meet) EXPECT_TRUE(is_found) << i << " and " << j;
      if (!moves || !a.overlaps(b)) EXPECT_FALSE(is_found) << i << " and " << j;
    }
  }
}

TEST(BroadPhase, finds_a_pair_that_meets_during_its_motion) {
  test::MovingSheets sheets;
  sheets.add(test::closed_box({0.1, 0.1, 0.1}), {-1, 0, 0});
  sheets.add(test::closed_box({0.1, 0.1, 0.1}), {1, 0, 0});
  EXPECT_TRUE(near_pairs(sheets.bodies()).empty());
  sheets.body(0).motion.velocity = {240, 0, 0};
  EXPECT_EQ(near_pairs(sheets.bodies()), (Pairs{{0, 1}}));
}

// Two long boxes across each other lie apart, though their bounds in the world overlap.
TEST(BroadPhase, skips_a_pair_separated_in_a_local_frame) {
  const glm::dquat turned = glm::normalize(glm::dquat(1, 0, std::tan(3.14159265358979 / 8), 0));
  test::MovingSheets sheets;
  sheets.add(test::closed_box({4, 0.1, 0.1}), {0, 0, 0}, turned);
  sheets.add(test::closed_box({4, 0.1, 0.1}), {0.5, 0, 0.5}, turned);
  const std::vector<MovingBody>& bodies = sheets.bodies();
  ASSERT_TRUE(bodies[0].bounds.overlaps(bodies[1].bounds));
  EXPECT_TRUE(near_pairs(bodies).empty());
}

TEST(BroadPhase, skips_bodies_sliding_along_fixed_ones) {
  test::MovingSheets sheets;
  sheets.add(test::closed_box({1, 1, 1}), {0, 0, 0});
  sheets.add(test::closed_box({1, 1, 1}), {0.5, 0, 0});
  sheets.body(1).pinned = true;
  std::vector<MovingBody>& bodies = sheets.bodies();
  EXPECT_EQ(near_pairs(bodies).size(), 1u);
  bodies[0].passes_fixed = true;
  EXPECT_TRUE(near_pairs(bodies).empty());
}

}  // namespace
}  // namespace kerf
