#include "core/physics/motion_limits.h"

#include <gtest/gtest.h>

#include "tests/core/physics/moving_sheets.h"
#include "tests/support/sheets.h"

namespace kerf {
namespace {

// Two plates above each other near the ground, and a third one elsewhere.
class ContactSearchTest : public testing::Test {
 protected:
  ContactSearchTest() {
    around_.ground = 0;
    sheets_.add(test::rectangle(1, 1, 1), {0, 0.003, 0});
    sheets_.add(test::rectangle(1, 1, 1), {0, 0.008, 0});
    sheets_.add(test::rectangle(1, 1, 1), {9, 5, 0});
  }
  ContactSearch found() {
    ContactSearch search(sheets_.bodies(), joints_, around_, before_);
    search.find();
    return search;
  }

  test::MovingSheets sheets_;
  Environment around_;
  ContactMemory before_;
  std::vector<BodyJoint> joints_;
};

TEST_F(ContactSearchTest, finds_contacts_of_pairs_and_with_the_ground_in_order) {
  ContactSearch search = found();
  ASSERT_EQ(search.pairs().size(), 2u + 1u);
  const auto is = [&](size_t i, uint32_t first, uint32_t second) {
    return search.pairs()[i].first == first && search.pairs()[i].second == second;
  };
  EXPECT_TRUE(is(0, 0, 1) && is(1, 0, TouchingPair::kGround) && is(2, 1, TouchingPair::kGround));
  for (const TouchingPair& pair : search.pairs()) EXPECT_FALSE(pair.contacts.empty());
  EXPECT_EQ(search.candidates(), 1u);
}

TEST_F(ContactSearchTest, returns_each_pair_once_even_if_added_twice) {
  ContactSearch search = found();
  search.allow_intersection(0, 1);
  ASSERT_EQ(search.pairs().size(), 3u);
  EXPECT_EQ(search.pairs()[0].memory.crossed, 1u);
  search.allow_intersection(0, 2);
  EXPECT_EQ(search.pairs().size(), 4u);
}

TEST_F(ContactSearchTest, skips_pairs_connected_by_a_joint) {
  const Joint joint{};
  joints_ = {{0, 1, &joint}};
  ContactSearch search = found();
  for (const TouchingPair& pair : search.pairs()) EXPECT_EQ(pair.second, TouchingPair::kGround);
}

TEST_F(ContactSearchTest, skips_sleeping_bodies) {
  for (uint32_t i = 0; i < 3; ++i) sheets_.body(i).motion.asleep = true;
  EXPECT_TRUE(found().pairs().empty());
}

TEST_F(ContactSearchTest, counts_the_ticks_a_pair_has_intersected) {
  sheets_.body(1).placement.orientation = glm::angleAxis(1.57, Vec3(1, 0, 0));
  ContactSearch first = found();
  EXPECT_EQ(first.pairs()[0].memory.crossed, 1u);
  before_ = {first.pairs()[0].memory};
  EXPECT_EQ(found().pairs()[0].memory.crossed, 2u);
  before_[0].crossed = 0;
  EXPECT_EQ(found().pairs()[0].memory.crossed, 0u) << "a pair that was apart is not judged anew";
}

TEST_F(ContactSearchTest, preserves_speed_only_in_the_first_tick_of_a_limited_contact) {
  // The edges of two plates in one plane, which meet within the tick.
  test::MovingSheets sheets;
  sheets.add(test::rectangle(1, 1, 1), Vec3(0));
  sheets.add(test::rectangle(1, 0.6, 1), {1.0005, 0, 0}, glm::angleAxis(0.02, Vec3(1, 0, 0)));
  sheets.body(0).motion.velocity = {0.002 / kTick, 0, 0};
  std::vector<MovingBody>& bodies = sheets.bodies();
  const std::vector<std::pair<uint32_t, uint32_t>> pair{{0, 1}};
  ContactMemory before;
  const auto remember = [&] {
    ContactSearch search(bodies, {}, around_, before);
    search.find();
    const bool keeps_speed = search.remember_piercing(pair)[0] != 0;
    before = {search.pairs()[0].memory};
    before[0].points_of_first.clear();  // as contacts that were not pressed are forgotten
    before[0].points_of_second.clear();
    return keeps_speed;
  };
  EXPECT_TRUE(remember());
  EXPECT_FALSE(remember());
  ContactSearch one_tick_later(bodies, {}, around_, before);
  one_tick_later.find();
  before = {one_tick_later.pairs()[0].memory};
  EXPECT_TRUE(remember()) << "after a tick in which they were not held";
}

TEST_F(ContactSearchTest, allows_a_pair_to_intersect_on_request) {
  using Pairs = std::vector<std::pair<uint32_t, uint32_t>>;
  ContactSearch search = found();
  EXPECT_EQ(search.pairs_apart(), (Pairs{{0, 1}}));
  search.allow_intersection(0, 1);
  EXPECT_TRUE(search.pairs_apart().empty());
  EXPECT_EQ(search.pairs()[0].memory.crossed, 1u);
}

}  // namespace
}  // namespace kerf
