#include "core/physics/contact/penetration.h"

#include <gtest/gtest.h>

#include "tests/core/physics/moving_sheets.h"
#include "tests/support/sheets.h"

namespace kerf {
namespace {

// A small plate over the middle of a large one.
class PlateOverPlate : public testing::Test {
 protected:
  PlateOverPlate() {
    sheets_.add(test::rectangle(0.4, 0.4, 1), {0, 0, 0});
    sheets_.add(test::rectangle(4, 4, 1), {0, 0, 0});
  }
  std::vector<Contact> find(double height, double sinking = 0) {
    sheets_.body(0).placement.position.y = height;
    sheets_.body(0).motion.velocity = {0, -sinking, 0};
    std::vector<Contact> found;
    const std::vector<MovingBody>& bodies = sheets_.bodies();
    find_point_contacts(bodies[0], bodies[1], kContactLengths, memory_, found);
    return found;
  }

  test::MovingSheets sheets_;
  std::vector<PointMemory> memory_;
};

TEST_F(PlateOverPlate, touches_with_its_corners_on_its_side) {
  for (const double side : {1.0, -1.0}) {
    memory_.clear();
    const auto found = find(0.006 * side);
    ASSERT_EQ(found.size(), 4u);
    for (const Contact& c : found) {
      EXPECT_NEAR(c.normal.y, side, 1e-9);
      EXPECT_NEAR(c.distance, 0.006 - kContactLengths.skin, 1e-9);
      EXPECT_NEAR(c.at.y, 0.006 * side, 1e-9);
      EXPECT_LT(c.feature, uint64_t{1} << 32);
    }
    EXPECT_EQ(memory_.size(), 4u);
  }
}

TEST_F(PlateOverPlate, is_found_out_of_reach_only_if_approaching) {
  EXPECT_TRUE(find(0.011).empty());
  EXPECT_TRUE(memory_.empty());
  EXPECT_EQ(find(0.3, 0.4 * 120).size(), 4u);
  EXPECT_TRUE(find(0.3, 0.2 * 120).empty());
}

TEST_F(PlateOverPlate, stays_on_its_side_after_slight_penetration) {
  find(0.001);
  sheets_.body(0).motion.velocity = Vec3(0);
  const auto found = find(0.0001);
  ASSERT_EQ(found.size(), 4u);
  for (const Contact& c : found) {
    EXPECT_GT(c.normal.y, 0.99);
    EXPECT_LT(c.distance, 0) << "the skins overlap";
  }
}

}  // namespace
}  // namespace kerf
