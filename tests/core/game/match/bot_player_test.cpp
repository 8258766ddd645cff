#include "core/game/match/match.h"

#include <gtest/gtest.h>

#include "tests/support/game_files.h"

namespace kerf {
namespace {

TEST(BotPlayer, is_deterministic) {
  Match match({test::flat_rules(1, 1), 5, Difficulty::kNormal});
  BotPlayer first(match), same(match);
  for (int t = 0; t < 60; ++t) {
    const Controls controls = first.next(match);
    ASSERT_EQ(same.next(match), controls) << "tick " << t;
    match.tick(controls);
  }
}

TEST(BotPlayer, cuts_its_enemy_within_five_seconds) {
  Match match({test::flat_rules(1, 1), 1, Difficulty::kEasy});
  BotPlayer bot(match);
  for (Ticks t = 0; t < 5 * kTicksPerSecond && match.standing().faces_removed == 0; ++t)
    match.tick(bot.next(match));
  EXPECT_GT(match.standing().faces_removed, 0u);
  EXPECT_GT(match.strokes(), 0u);
}

TEST(BotPlayer, without_enemies_stands_still) {
  Match match({test::flat_rules(0, 0), 1, Difficulty::kNormal});
  BotPlayer bot(match);
  const Controls controls = bot.next(match);
  EXPECT_TRUE(controls.throttle == 0 && controls.steer == 0 && !controls.fire);
}

}  // namespace
}  // namespace kerf
