#include <gtest/gtest.h>

#include "core/game/match/match.h"
#include "tests/support/game_files.h"

namespace kerf {
namespace {

TEST(Match, is_lost_when_its_time_is_over) {
  auto rules = std::make_shared<Rules>(*test::flat_rules(1, 1));
  rules->description.times.match = 0.5;
  Match match({rules, 1, Difficulty::kNormal});
  for (int t = 0; t < 100; ++t) match.tick({});
  EXPECT_EQ(match.standing().phase, Standing::Phase::kLost);
  EXPECT_EQ(match.standing().ticks, 60u);
}

TEST(Match, without_enemies_ends_neither_won_nor_lost) {
  auto rules = std::make_shared<Rules>(*test::flat_rules(0, 0));
  rules->description.times.match = 0.5;
  Match match({rules, 1, Difficulty::kNormal});
  for (int t = 0; t < 100; ++t) match.tick({});
  EXPECT_TRUE(match.standing().over());
  EXPECT_EQ(match.standing().phase, Standing::Phase::kEnded);
  EXPECT_EQ(match.standing().ticks, 60u);
}

// Waves of one enemy that neither drives nor fires.
std::shared_ptr<Rules> waves_of_one(size_t waves, double pause) {
  auto rules = std::make_shared<Rules>(*test::flat_rules(waves, 1));
  rules->description.times.between_waves = pause;
  for (EnemySkill& skill : rules->description.skills) skill.speed = skill.fire = 0;
  return rules;
}

TEST(Match, is_lost_when_the_player_has_no_time_left_and_not_before) {
  auto rules = waves_of_one(1, 1);
  rules->description.times.match = 1;
  Match match({rules, 1, Difficulty::kNormal});
  for (Ticks t = 0; t + 1 < kTicksPerSecond; ++t) match.tick({});
  EXPECT_FALSE(match.standing().over());
  EXPECT_NEAR(match.seconds_left(), kTick, 1e-9);
  match.tick({});
  EXPECT_EQ(match.standing().phase, Standing::Phase::kLost);
  const Ticks ticks = match.standing().ticks;
  match.tick({});
  EXPECT_EQ(match.standing().ticks, ticks) << "nothing happens any more";
}

TEST(Match, tells_when_a_wave_begins) {
  Match match({waves_of_one(2, 1), 1, Difficulty::kNormal});
  ASSERT_EQ(match.events().size(), 1u);
  EXPECT_EQ(match.events()[0].kind, Event::Kind::kWaveBegins);
  EXPECT_EQ(match.events()[0].part, 0u);
  EXPECT_TRUE(match.delta().anew);
  match.tick({});
  EXPECT_TRUE(match.events().empty());
}

TEST(Match, goes_on_where_a_wave_began) {
  const auto rules = waves_of_one(3, 1);
  WaveStart start;
  start.standing.wave = 2;
  start.standing.ticks = 100;
  start.standing.score = 7;
  start.player.position = {3, 0, 4};
  const Match match({rules, 1, Difficulty::kNormal}, start);
  EXPECT_EQ(match.standing().wave, 2u);
  EXPECT_EQ(match.standing().ticks, 100u);
  EXPECT_EQ(match.standing().score, 7);
  EXPECT_EQ(match.world().body(match.vehicles()[Match::kPlayer].chassis).placement.position, Vec3(3, 0, 4));
}

}  // namespace
}  // namespace kerf
