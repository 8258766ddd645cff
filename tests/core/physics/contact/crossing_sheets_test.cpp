#include "core/physics/contact/penetration.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/base/ids.h"
#include "core/base/random.h"
#include "tests/core/physics/moving_sheets.h"
#include "tests/support/piles.h"
#include "tests/support/sheets.h"

namespace kerf {
namespace {

TEST(CrossingSheets, have_an_edge_that_pierces_a_face) {
  Random random(6);
  size_t crossing = 0;
  for (int i = 0; i < 60; ++i) {
    const auto turn = [&] {
      return glm::normalize(
          glm::dquat(random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1), 0.1));
    };
    test::MovingSheets sheets;
    sheets.add(test::rectangle(1, 0.6, 4), Vec3(0), turn());
    sheets.add(test::rectangle(1, 1, 4), {random.unit(), 0.2, random.unit()}, turn());
    const bool expected = test::intersect(sheets.body(0), sheets.body(1));
    const std::vector<MovingBody>& bodies = sheets.bodies();
    EXPECT_EQ(sheets_cross(bodies[0], bodies[1]), expected) << "pair " << i << " of seed 6";
    EXPECT_EQ(sheets_cross(bodies[1], bodies[0]), expected);
    crossing += expected;
  }
  EXPECT_GT(crossing, 10u);
  EXPECT_LT(crossing, 50u);
}

// A plate that falls by so many metres in a tick, from 0.1 m above another one.
bool falls_through(double way) {
  test::MovingSheets sheets;
  sheets.add(test::rectangle(0.4, 0.4, 2), {0, 0.1, 0});
  sheets.add(test::rectangle(4, 4, 2), Vec3(0));
  sheets.body(0).motion.velocity = {0, -way / kTick, 0};
  const std::vector<MovingBody>& bodies = sheets.bodies();
  EXPECT_FALSE(sheets_cross(bodies[0], bodies[1]));
  return pass_through(bodies[0], bodies[1]);
}

TEST(CrossingSheets, passing_within_a_tick_count_as_tunnelled) {
  EXPECT_FALSE(falls_through(0.09));
  EXPECT_TRUE(falls_through(0.11));
  EXPECT_TRUE(falls_through(3)) << "they do not intersect at its end";
}

}  // namespace
}  // namespace kerf
