
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "core/physics/contact/contact.h"
#include "tests/core/physics/moving_sheets.h"
#include "tests/support/sheets.h"

namespace kerf {
namespace {

TEST(PairContacts, are_at_most_eight_including_the_deepest) {
  Soup soup = test::disc(0.5, 64);
  soup.positions[6].y = -0.002;  // of 64 on the rim
  test::MovingSheets sheets;
  sheets.add(soup, {0, 0.006, 0});
  sheets.add(test::rectangle(4, 4, 1), Vec3(0));
  const std::vector<MovingBody>& bodies = sheets.bodies();
  PairMemory memory{bodies[0].id, bodies[1].id, {}, {}, {}};
  const auto found = find_contacts(bodies[0], bodies[1], kContactLengths, memory);
  EXPECT_EQ(found.size(), 8u);
  double deepest = 1;
  for (const Contact& c : found) deepest = std::min(deepest, c.distance);
  EXPECT_NEAR(deepest, 0.004 - kContactLengths.skin, 1e-9);
}

TEST(PairContacts, found_from_the_second_body_lie_on_the_first_and_push_it) {
  test::MovingSheets sheets;
  sheets.add(test::rectangle(4, 4, 1), {0, 0.006, 0});
  sheets.add(test::rectangle(0.4, 0.4, 1), Vec3(0));
  const std::vector<MovingBody>& bodies = sheets.bodies();
  PairMemory memory{bodies[0].id, bodies[1].id, {}, {}, {}};
  const auto found = find_contacts(bodies[0], bodies[1], kContactLengths, memory);
  ASSERT_EQ(found.size(), 4u);
  for (const Contact& c : found) EXPECT_NEAR(c.normal.y, 1, 1e-9);
  EXPECT_TRUE(memory.points_of_first.empty());
  EXPECT_EQ(memory.points_of_second.size(), 4u);
}

TEST(PairContacts, of_intersecting_sheets_forget_their_points) {
  const glm::dquat standing(std::sqrt(0.5), std::sqrt(0.5), 0, 0);
  test::MovingSheets sheets;
  sheets.add(test::rectangle(0.5, 0.5, 4), {0.05, 0.23, 0}, standing);  // reaches 0.02 m through the other
  sheets.add(test::rectangle(4, 4, 2), {0, 0, 0.01});
  const std::vector<MovingBody>& bodies = sheets.bodies();
  PairMemory memory{bodies[0].id, bodies[1].id, {{1, {0, 1, 0}}}, {{2, {0, 1, 0}}}, {}};
  memory.crossed = 1;
  EXPECT_EQ(find_contacts(bodies[0], bodies[1], kContactLengths, memory).size(), 1u)
      << "which pushes them out";
  EXPECT_TRUE(memory.points_of_first.empty());
  EXPECT_TRUE(memory.points_of_second.empty());
}

TEST(PairContacts, reuse_impulses_of_the_last_tick_by_feature) {
  test::MovingSheets sheets;
  sheets.add(test::rectangle(0.4, 0.4, 1), {0, 0.006, 0});
  sheets.add(test::rectangle(4, 4, 1), Vec3(0));
  const std::vector<MovingBody>& bodies = sheets.bodies();
  PairMemory memory{bodies[0].id, bodies[1].id, {}, {}, {}};
  auto found = find_contacts(bodies[0], bodies[1], kContactLengths, memory);
  ASSERT_EQ(found.size(), 4u);
  found[2].impulse = {3, 1, 2};
  remember_impulses(found, memory);
  EXPECT_TRUE(memory.touching);
  EXPECT_EQ(memory.impulses.size(), 1u) << "of those that were pressed";
  const auto again = find_contacts(bodies[0], bodies[1], kContactLengths, memory);
  EXPECT_EQ(again[2].impulse, found[2].impulse);
  EXPECT_EQ(again[1].impulse[0], 0);
  for (Contact& c : found) c.impulse = {};
  remember_impulses(found, memory);
  EXPECT_FALSE(memory.touching);
}

}  // namespace
}  // namespace kerf
