#include "core/world/rigid_body.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "core/world/world.h"
#include "tests/support/sheets.h"

namespace kerf {
namespace {

TEST(BodyState, is_stored_for_bodies_that_move_or_have_moved) {
  World world;
  const auto add = [&] { return test::add(world, test::rectangle(1, 1, 1), {1, 2, 3}); };
  add();
  const BodyId moving = add(), asleep = add(), quiet = add();
  world.body(moving).motion.velocity = {1, 0, 0};
  world.body(asleep).motion.asleep = true;
  world.body(quiet).motion.quiet = 1;
  const BodyId rest = test::add(world, test::rectangle(1, 1, 1), Vec3(0));
  const std::vector<BodyState> states = moved_bodies(world, false);
  ASSERT_EQ(states.size(), 3u);
  EXPECT_EQ(states[0].id, moving);
  EXPECT_EQ(states[0].placement.position, Vec3(1, 2, 3));
  EXPECT_EQ(states[0].motion.velocity, Vec3(1, 0, 0));
  EXPECT_EQ(states[1].id, asleep);
  EXPECT_EQ(states[2].id, quiet);
  const std::vector<BodyState> in_time = moved_bodies(world, true);
  ASSERT_EQ(in_time.size(), 4u) << "the first one may have moved before it was pinned or woken";
  EXPECT_TRUE(std::ranges::none_of(in_time, [&](const BodyState& s) { return s.id == rest; }));
}

TEST(StoredPairs, are_read_and_set_without_details) {
  World world;
  PairMemory pair{BodyId{1, 0}, BodyId{2, 0}, {{3, {0, 1, 0}}}, {}, {{4, {1, 2, 3}}}};
  pair.touching = true;
  pair.crossed = 7;
  world.set_contact_memory({pair, {BodyId{2, 0}, BodyId{}, {}, {}, {}}});
  const std::vector<NearPair> pairs = known_pairs(world);
  ASSERT_EQ(pairs.size(), 2u);
  EXPECT_EQ(pairs[0], (NearPair{{1, 0}, {2, 0}, true, 7}));
  EXPECT_FALSE(pairs[1].second.valid());
  set_known_pairs(world, pairs);
  EXPECT_EQ(known_pairs(world), pairs);
  EXPECT_TRUE(world.contact_memory()[0].points_of_first.empty());
  EXPECT_TRUE(world.contact_memory()[0].impulses.empty());
}

}  // namespace
}  // namespace kerf
