#include "core/physics/contact/contact.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/core/physics/moving_sheets.h"
#include "tests/support/sheets.h"

namespace kerf {
namespace {

const glm::dquat kUpright(std::sqrt(0.5), std::sqrt(0.5), 0, 0);  // about x: a level sheet stands

// A sheet stands on its edge above the edge of another one that is turned by a right angle.
class CrossedEdges : public testing::Test {
 protected:
  // `upside_down`: the lower sheet is turned by half a turn in its plane.
  std::vector<Contact> find(double gap, double sinking = 0, bool upside_down = false) {
    sheets_ = test::MovingSheets();
    glm::dquat across = glm::dquat(std::sqrt(0.5), 0, std::sqrt(0.5), 0) * kUpright;
    if (upside_down) across = across * glm::dquat(0, 0, 1, 0);
    sheets_.add(test::rectangle(1, 1, 1), {0.1, 0.5 + gap, 0.2}, kUpright);
    sheets_.add(test::rectangle(1, 1, 1), {0, -0.5, 0}, across);
    sheets_.body(0).motion.velocity = {0, -sinking, 0};
    std::vector<Contact> found;
    const std::vector<MovingBody>& bodies = sheets_.bodies();
    find_chord_contacts(bodies[0], bodies[1], kContactLengths, found);
    return found;
  }

  test::MovingSheets sheets_;
};

TEST_F(CrossedEdges, touch_where_they_cross) {
  const auto found = find(0.004);
  ASSERT_EQ(found.size(), 1u);
  EXPECT_NEAR(found[0].normal.y, 1, 1e-9) << "towards the first body";
  EXPECT_NEAR(found[0].distance, 0.004 - kContactLengths.chord_skin, 1e-9);
  EXPECT_NEAR(glm::distance(found[0].at, Vec3(0, 0.004, 0.2)), 0, 1e-9);
  EXPECT_GE(found[0].feature, uint64_t{1} << 32);
}

TEST_F(CrossedEdges, are_found_within_reach_and_farther_if_approaching) {
  EXPECT_TRUE(find(kContactLengths.reach * 1.1).empty());
  for (const bool upside_down : {false, true}) {
    EXPECT_EQ(find(0.05, 0.06 * 120, upside_down).size(), 1u);
    EXPECT_TRUE(find(0.05, 0.03 * 120, upside_down).empty());
  }
}

TEST(ChordContacts, need_an_angle_with_a_squared_sine_above_a_thousandth) {
  for (const double degrees : {1.7, 2.2}) {
    SCOPED_TRACE(degrees);
    const glm::dquat turned = glm::angleAxis(degrees * 3.14159265358979 / 180, Vec3(0, 1, 0)) * kUpright;
    test::MovingSheets sheets;
    sheets.add(test::rectangle(1, 1, 1), {0, 0.504, 0}, kUpright);
    sheets.add(test::rectangle(1, 1, 1), {0, -0.5, 0}, turned);
    const std::vector<MovingBody>& bodies = sheets.bodies();
    std::vector<Contact> found;
    find_chord_contacts(bodies[0], bodies[1], kContactLengths, found);
    EXPECT_EQ(found.size(), degrees > 2 ? 1u : 0u);
  }
}

TEST(ChordContacts, ignore_parallel_edges) {
  test::MovingSheets sheets;
  sheets.add(test::rectangle(1, 1, 1), {0, 0.504, 0}, kUpright);
  sheets.add(test::rectangle(1, 1, 1), {0, -0.5, 0}, kUpright);
  const std::vector<MovingBody>& bodies = sheets.bodies();
  std::vector<Contact> found;
  find_chord_contacts(bodies[0], bodies[1], kContactLengths, found);
  EXPECT_TRUE(found.empty());
}

}  // namespace
}  // namespace kerf
