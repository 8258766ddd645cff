#include "core/game/match/match_world.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <optional>

#include "tests/support/sheets.h"

namespace kerf {
namespace {

Delta changed(std::initializer_list<BodyId> ids) {
  Delta delta;
  for (const BodyId id : ids) delta.bodies.emplace_back().body = id;
  return delta;
}

Delta came_off(BodyId from, BodyId to, bool keeps_slots) {
  Delta delta = changed({keeps_slots ? to : from});
  delta.created = {keeps_slots ? from : to};
  delta.detached = {{from, 1, to, keeps_slots}};
  return delta;
}

class StaleCollidersTest : public testing::Test {
 protected:
  StaleCollidersTest() {
    for (BodyId& id : small_) id = test::add(world_, test::rectangle(1, 1, 4), Vec3(0));
    for (BodyId& id : large_) id = test::add(world_, test::rectangle(1, 1, 40), Vec3(0));
  }

  // The tick in which the collider of a body is renewed, or nothing within a second.
  std::optional<Ticks> renewed(BodyId id, StaleColliders stale) const {
    for (Ticks now = 0; now < kTicksPerSecond; ++now) {
      const std::vector<BodyId> due = stale.take_due(world_, now);
      if (std::find(due.begin(), due.end(), id) != due.end()) return now;
    }
    return std::nullopt;
  }

  World world_;
  std::array<BodyId, 2> small_, large_;
  StaleColliders stale_;
};

TEST_F(StaleCollidersTest, are_rebuilt_once_shortly_after_the_first_removal) {
  stale_.note(changed({small_[0]}), 3);
  stale_.note(changed({small_[0]}), 10);
  EXPECT_EQ(renewed(small_[0], stale_), 18u);
  EXPECT_EQ(stale_.take_due(world_, 18), std::vector{small_[0]});
  EXPECT_TRUE(stale_.take_due(world_, 100).empty());
}

TEST_F(StaleCollidersTest, are_rebuilt_in_the_next_tick_after_a_piece_comes_off) {
  stale_.note(changed({large_[0]}), 3);
  stale_.note(came_off(large_[0], small_[0], false), 4);
  EXPECT_EQ(renewed(large_[0], stale_), 5u);
  EXPECT_EQ(renewed(small_[0], stale_), std::nullopt) << "it has none yet";
}

TEST_F(StaleCollidersTest, are_dropped_if_bodies_are_destroyed_or_swap_faces) {
  stale_.note(changed({small_[0], large_[0]}), 0);
  Delta destroyed_body;
  destroyed_body.destroyed = {small_[0]};
  stale_.note(destroyed_body, 1);
  stale_.note(came_off(large_[0], large_[1], true), 2);
  for (const BodyId id : {small_[0], large_[0], large_[1]}) EXPECT_EQ(renewed(id, stale_), std::nullopt);
}

TEST_F(StaleCollidersTest, are_rebuilt_in_different_ticks_for_two_large_bodies) {
  stale_.note(changed({large_[1]}), 0);
  stale_.note(changed({large_[0], small_[0], small_[1]}), 0);
  EXPECT_EQ(stale_.take_due(world_, 15), (std::vector{small_[0], small_[1], large_[0]}));
  EXPECT_EQ(stale_.take_due(world_, 16), std::vector{large_[1]});
}

}  // namespace
}  // namespace kerf
