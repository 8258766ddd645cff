#include "core/physics/motion_limits.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/base/ids.h"
#include "core/physics/contact/penetration.h"
#include "tests/core/physics/moving_sheets.h"
#include "tests/support/sheets.h"

namespace kerf {
namespace {

// A plate that goes down by so many metres in a tick, 0.1 m above a sheet.
class PlateOverSheet : public testing::Test {
 protected:
  PlateOverSheet() {
    sheets_.add(test::rectangle(0.4, 0.4, 2), {0, 0.1, 0});
    sheets_.add(test::rectangle(4, 4, 2), Vec3(0));
    sheets_.body(1).pinned = true;
  }
  // Moves the bodies and holds them back. Returns how many were.
  size_t go(double way, double ignored_mass = 0) {
    sheets_.body(0).motion.velocity = {0, -way / kTick, 0};
    std::vector<MovingBody>& bodies = sheets_.bodies();
    bodies[0].ignored_mass = ignored_mass;
    ContactSearch search(bodies, {}, around_, before_);
    search.find();
    sheets_.move_on();
    const size_t held = limit_penetration(bodies, search);
    if (ignored_mass == 0) EXPECT_FALSE(pass_through(bodies[0], bodies[1]));
    return held;
  }
  double height() { return sheets_.body(0).placement.position.y; }
  double speed() { return -sheets_.body(0).motion.velocity.y * kTick; }

  test::MovingSheets sheets_;
  Environment around_;
  ContactMemory before_;
};

TEST_F(PlateOverSheet, moves_its_full_path_without_obstacles) {
  EXPECT_EQ(go(0.09), 0u);
  EXPECT_NEAR(height(), 0.01, 1e-12);
  EXPECT_NEAR(speed(), 0.09, 1e-12);
}

TEST_F(PlateOverSheet, moves_the_largest_fraction_that_stays_on_its_side) {
  for (const auto& [way, share] : {std::pair{0.15, 0.5}, {0.3, 0.25}, {0.9, 0.0}}) {
    sheets_.body(0).placement.position = {0, 0.1, 0};
    EXPECT_EQ(go(way), 1u);
    EXPECT_NEAR(height(), 0.1 - share * way, 1e-9) << way;
    EXPECT_LT(speed(), way) << "its motion is slowed";
  }
}

TEST_F(PlateOverSheet, turns_by_the_fraction_of_its_path) {
  sheets_.body(0).motion.spin = {0, 0.4 / kTick, 0};
  EXPECT_EQ(go(0.15), 1u);
  EXPECT_NEAR(height(), 0.1 - 0.5 * 0.15, 1e-9);
  // The whole turn has a half angle whose tangent is 0.2.
  const glm::dquat& turned = sheets_.body(0).placement.orientation;
  EXPECT_NEAR(std::asin(turned.y), 0.5 * std::atan(0.2), 1e-9);
}

TEST_F(PlateOverSheet, does_not_stop_a_much_heavier_body) {
  sheets_.body(1).pinned = false;
  sheets_.body(1).motion.velocity = {0, 0.01 / kTick, 0};
  EXPECT_EQ(go(0.15), 1u);
  EXPECT_NEAR(sheets_.body(1).placement.position.y, 0.01, 1e-9);
  EXPECT_LT(0.1 - height(), 0.15);
}

TEST_F(PlateOverSheet, pushes_aside_a_body_too_light_to_stop_it) {
  sheets_.body(1).pinned = false;
  EXPECT_EQ(go(0.15, 1e6), 0u);
  EXPECT_NEAR(height(), 0.1 - 0.15, 1e-9);
}

// On their full ways, only the lower plate passes through the sheet; where it is held back, the upper one
// would pass through it.
TEST(LimitPenetration, limits_a_body_that_follows_a_limited_one) {
  test::MovingSheets sheets;
  sheets.add(test::rectangle(0.4, 0.4, 2), {0, 0.1, 0});
  sheets.add(test::rectangle(4, 4, 2), {0.03, 0, 0.01});
  sheets.add(test::rectangle(0.4, 0.4, 2), {0.05, 0.12, 0.02});
  sheets.body(1).pinned = true;
  sheets.body(0).motion.velocity = {0, -0.15 / kTick, 0};
  sheets.body(2).motion.velocity = {0, -0.11 / kTick, 0};
  const Environment around;
  const ContactMemory before;
  std::vector<MovingBody>& bodies = sheets.bodies();
  EXPECT_FALSE(pass_through(bodies[0], bodies[2]));
  ContactSearch search(bodies, {}, around, before);
  search.find();
  sheets.move_on();
  EXPECT_EQ(limit_penetration(bodies, search), 2u);
  EXPECT_FALSE(pass_through(bodies[0], bodies[1]) || pass_through(bodies[0], bodies[2]));
  EXPECT_GT(sheets.body(2).placement.position.y, sheets.body(0).placement.position.y);
}

TEST(LimitPenetration, limits_a_body_that_meets_two_others_only_once) {
  test::MovingSheets sheets;
  sheets.add(test::rectangle(1, 0.4, 4), {0, 0.1, 0});
  for (const double x : {-0.3, 0.3}) {
    const uint32_t below = sheets.add(test::rectangle(0.4, 0.6, 2), {x, 0, 0});
    sheets.body(below).pinned = true;
  }
  sheets.body(0).motion.velocity = {0, -0.15 / kTick, 0};
  const Environment around;
  const ContactMemory before;
  std::vector<MovingBody>& bodies = sheets.bodies();
  ContactSearch search(bodies, {}, around, before);
  search.find();
  sheets.move_on();
  EXPECT_EQ(limit_penetration(bodies, search), 1u);
  EXPECT_NEAR(sheets.body(0).placement.position.y, 0.1 - 0.5 * 0.15, 1e-9);
}

}  // namespace
}  // namespace kerf
