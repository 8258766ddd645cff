#include "core/physics/contact/penetration.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/base/ids.h"
#include "tests/core/physics/moving_sheets.h"
#include "tests/support/sheets.h"

namespace kerf {
namespace {

const glm::dquat kStanding(std::sqrt(0.5), std::sqrt(0.5), 0, 0);  // about x

// A standing plate of half a metre that reaches through a level one by so much.
class PlateThroughPlate : public testing::Test {
 protected:
  std::optional<Contact> push(double depth, uint32_t ticks) {
    test::MovingSheets sheets;
    sheets.add(test::rectangle(0.5, 0.5, 4), {0.05, 0.25 - depth, 0}, kStanding);
    sheets.add(test::rectangle(4, 4, 2), {0, 0, 0.01});
    const std::vector<MovingBody>& bodies = sheets.bodies();
    PairMemory memory{bodies[0].id, bodies[1].id, {}, {}, {}};
    memory.crossed = ticks;
    return push_out(bodies[0], bodies[1], memory);
  }
};

TEST_F(PlateThroughPlate, is_pushed_out_along_the_shortest_path) {
  const auto up = push(0.02, 1), down = push(0.48, 1);
  ASSERT_TRUE(up && down);
  EXPECT_NEAR(up->normal.y, 1, 1e-9);
  EXPECT_NEAR(down->normal.y, -1, 1e-9);
  EXPECT_NEAR(up->at.y, 0, 0.03);
  EXPECT_NEAR(-up->distance * kSolvedShare / kTick, kPushOut, 1e-12);
}

TEST_F(PlateThroughPlate, is_not_pushed_if_that_would_take_too_long) {
  EXPECT_TRUE(push(0.119, 1));
  EXPECT_FALSE(push(0.121, 1));
  EXPECT_TRUE(push(0.119, static_cast<uint32_t>(kMaxPush * kTicksPerSecond) - 1));
  EXPECT_FALSE(push(0.001, static_cast<uint32_t>(kMaxPush * kTicksPerSecond)));
}

TEST(PushOut, keeps_the_last_direction_and_turns_it_to_a_shorter_one) {
  test::MovingSheets sheets;
  sheets.add(test::rectangle(0.12, 0.12, 4), {0, 0.01, 0}, kStanding);  // the way up is the shorter one
  sheets.add(test::rectangle(0.3, 0.3, 4), {0.003, 0, 0.01});
  const std::vector<MovingBody>& bodies = sheets.bodies();
  const Vec3 before = glm::normalize(Vec3(0.05, -1, 0));
  PairMemory memory{bodies[0].id, bodies[1].id, {}, {}, {}};
  memory.crossed = 1;
  memory.way_out = before;
  const auto contact = push_out(bodies[0], bodies[1], memory);
  ASSERT_TRUE(contact);
  EXPECT_LT(contact->normal.y, before.y);
  EXPECT_NEAR(contact->normal.y, -1, 1e-4);
  EXPECT_EQ(memory.way_out, contact->normal);
}

TEST(PushOut, is_none_without_intersection) {
  test::MovingSheets sheets;
  sheets.add(test::rectangle(0.5, 0.5, 4), {0, 0.3, 0}, kStanding);
  sheets.add(test::rectangle(4, 4, 2), Vec3(0));
  const std::vector<MovingBody>& bodies = sheets.bodies();
  PairMemory memory{bodies[0].id, bodies[1].id, {}, {}, {}};
  memory.crossed = 1;
  EXPECT_FALSE(push_out(bodies[0], bodies[1], memory));
}

}  // namespace
}  // namespace kerf
