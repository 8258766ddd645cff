#include "core/physics/sleep.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "tests/support/sheets.h"

namespace kerf {
namespace {

// Three sheets that sleep: the first lies on the second, the third on the ground elsewhere.
class SleepingSheets : public testing::Test {
 protected:
  SleepingSheets() {
    for (BodyId& id : ids_) {
      id = test::add(world_, test::rectangle(1, 1, 1), Vec3(0));
      world_.body(id).motion.asleep = true;
      world_.body(id).motion.quiet = 60;
    }
    PairMemory on_each_other{ids_[0], ids_[1], {{3, {0, 1, 0}}}, {}, {{3, {1, 2, 3}}}};
    PairMemory on_ground{ids_[2], BodyId{}, {}, {}, {{1, {4, 5, 6}}}};
    on_each_other.touching = on_ground.touching = true;
    world_.set_contact_memory({on_each_other, on_ground});
  }
  // Which of the sheets are awake.
  std::string awake() const {
    std::string text;
    for (size_t i = 0; i < 3; ++i) {
      if (!world_.body(ids_[i]).motion.asleep) text += std::to_string(i);
    }
    return text;
  }
  size_t known() const { return world_.contact_memory().size(); }

  World world_;
  std::array<BodyId, 3> ids_;
};

TEST_F(SleepingSheets, stay_asleep_on_an_empty_delta) {
  forget_contacts(world_, Delta{});
  EXPECT_EQ(awake(), "");
  EXPECT_EQ(known(), 2u);
}

TEST_F(SleepingSheets, wake_with_their_neighbours_when_one_is_moved) {
  Delta delta;
  delta.moved = {ids_[1]};
  forget_contacts(world_, delta);
  EXPECT_EQ(awake(), "01");
  ASSERT_EQ(known(), 1u);
  EXPECT_EQ(world_.contact_memory()[0].first, ids_[2]);
  EXPECT_EQ(world_.body(ids_[0]).motion.quiet, 0u);
}

TEST_F(SleepingSheets, wake_when_faces_are_added_or_removed_but_not_recoloured) {
  Delta delta;
  delta.bodies.emplace_back().body = ids_[2];
  forget_contacts(world_, delta);
  EXPECT_EQ(awake(), "");
  delta.bodies[0].dead.resize(1);
  forget_contacts(world_, delta);
  EXPECT_EQ(awake(), "2");
  EXPECT_EQ(known(), 1u);
}

TEST_F(SleepingSheets, all_wake_when_gravity_changes) {
  Delta delta;
  delta.environment = true;
  forget_contacts(world_, delta);
  EXPECT_EQ(awake(), "012");
  EXPECT_EQ(known(), 0u);
}

TEST_F(SleepingSheets, keep_their_pairs_when_contact_details_are_cleared) {
  forget_details(world_);
  EXPECT_EQ(awake(), "");
  ASSERT_EQ(known(), 2u);
  const PairMemory& pair = world_.contact_memory()[0];
  EXPECT_TRUE(pair.first == ids_[0] && pair.second == ids_[1] && pair.touching);
  EXPECT_TRUE(pair.points_of_first.empty() && pair.impulses.empty());
}

TEST_F(SleepingSheets, wake_for_changed_bodies_in_any_order) {
  forget_contacts(world_, {ids_[2], ids_[0]});
  EXPECT_EQ(awake(), "012");
  EXPECT_EQ(known(), 0u);
}

}  // namespace
}  // namespace kerf
