#include "core/physics/contact/contact.h"

#include <gtest/gtest.h>

#include "tests/core/physics/moving_sheets.h"
#include "tests/support/sheets.h"

namespace kerf {
namespace {

TEST(GroundContacts, are_at_the_lowest_corners) {
  test::MovingSheets sheets;
  sheets.add(test::closed_box({0.4, 0.4, 0.4}), {0, 0.205, 0});
  Environment around;
  const PairMemory memory{};
  EXPECT_TRUE(find_ground_contacts(sheets.bodies()[0], around, kContactLengths, memory).empty())
      << "no ground";
  around.ground = 0;
  const auto found = find_ground_contacts(sheets.bodies()[0], around, kContactLengths, memory);
  ASSERT_EQ(found.size(), 4u);
  for (const Contact& c : found) {
    EXPECT_EQ(c.normal, Vec3(0, 1, 0));
    EXPECT_NEAR(c.distance, 0.005 - kContactLengths.ground_skin, 1e-9);
  }
  around.ground = -0.02;
  EXPECT_TRUE(find_ground_contacts(sheets.bodies()[0], around, kContactLengths, memory).empty());
  sheets.body(0).motion.velocity = {0, -0.03 * 120, 0};
  EXPECT_EQ(find_ground_contacts(sheets.bodies()[0], around, kContactLengths, memory).size(), 4u)
      << "on its way";
}

TEST(GroundContacts, report_the_depth_of_the_lowest_sunken_corner) {
  test::MovingSheets sheets;
  sheets.add(test::closed_box({0.4, 0.4, 0.4}), {0, 0.15, 0}, glm::angleAxis(0.1, Vec3(0, 0, 1)));
  Environment around;
  const auto sunk = [&] {
    const MovingBody& box = sheets.bodies()[0];
    return depth_below_ground(box, box.now, around);
  };
  EXPECT_EQ(sunk(), 0) << "no ground";
  around.ground = 0;
  EXPECT_NEAR(sunk(), 0.2 * (std::cos(0.1) + std::sin(0.1)) - 0.15, 1e-12);
  sheets.body(0).placement.position.y = 0.3;
  EXPECT_EQ(sunk(), 0);
}

}  // namespace
}  // namespace kerf
