#include "ui/game/game_menu.h"

#include <gtest/gtest.h>

#include <set>

#include "tests/support/game_files.h"
#include "ui/game/hud.h"

namespace kerf {
namespace {

TEST(EndReason, is_the_time_if_nobody_was_hit) {
  auto rules = std::make_shared<Rules>(*test::flat_rules(1, 1));
  rules->description.times.match = 0.1;
  for (EnemySkill& skill : rules->description.skills) skill.speed = skill.fire = 0;
  Match match({rules, 1, Difficulty::kNormal});
  while (!match.standing().over()) match.tick({});
  EXPECT_EQ(end_reason(match), "Time is up");
}

// The vehicle is changed behind the back of the match, as no beam does it so quickly.
TEST(EndReason, names_the_lost_part_and_the_attacker) {
  Match match({test::flat_rules(1, 1), 1, Difficulty::kNormal});
  auto& own = const_cast<Vehicle&>(match.vehicles()[Match::kPlayer]);
  own.alive = false;
  match.tick({});
  EXPECT_EQ(end_reason(match, 1), "Your car was cut to pieces by the hatchback");
  own.vital_works[0] = false;
  EXPECT_EQ(end_reason(match, 1), "Your engine was cut off by the hatchback");
  EXPECT_EQ(end_reason(match), "Your engine was cut off");
}

TEST(GiveUpHint, tells_whether_another_car_follows) {
  auto rules = std::make_shared<Rules>(*test::flat_rules(2, 1));
  rules->description.cars = 2;
  Match match({rules, 1, Difficulty::kNormal});
  EXPECT_EQ(give_up_hint(match, "G"), "");
  const_cast<Vehicle&>(match.vehicles()[Match::kPlayer]).gun.turret_attached = false;
  EXPECT_EQ(give_up_hint(match, "G"), "Laser lost: press G to take your next car");
  auto& standing = const_cast<Standing&>(match.standing());
  standing.cars_left = 0;
  EXPECT_EQ(give_up_hint(match, "G"), "Laser lost: press G to end the match");
  standing.phase = Standing::Phase::kDown;
  EXPECT_EQ(give_up_hint(match, "G"), "Laser lost: press G to take your next car");
  for (const auto phase : {Standing::Phase::kPause, Standing::Phase::kWon, Standing::Phase::kEnded}) {
    standing.phase = phase;
    EXPECT_EQ(give_up_hint(match, "G"), "") << "the key does nothing";
  }
}

TEST(LossWarning, names_the_wave_only_where_there_are_waves) {
  auto rules = std::make_shared<Rules>(*test::flat_rules(2, 1));
  Match waves({rules, 1, Difficulty::kNormal});
  const_cast<Standing&>(waves.standing()).score = 450;
  EXPECT_EQ(loss_warning(waves), "Wave 1 and 450 points will be lost.");
  rules = std::make_shared<Rules>(*rules);
  rules->description.targets = true;
  Match trial({rules, 1, Difficulty::kNormal});
  const_cast<Standing&>(trial.standing()).score = 1;
  EXPECT_EQ(loss_warning(trial), "1 point will be lost.");
  Match sandbox({test::flat_rules(0, 0), 1, Difficulty::kNormal});
  EXPECT_EQ(loss_warning(sandbox), "0 points will be lost.");
}

TEST(MatchResult, counts_wrecks_only_in_a_fight) {
  MatchResult result;
  result.score = {450, "standard", "easy", false, 1, 200};
  result.pieces = 9;
  EXPECT_EQ(words_on_course(result), "1 wreck, 9 pieces cut, 0 wheels lost, 3:20");
  result.score = {450, "trial", "", false, 0, 80};
  EXPECT_FALSE(result.fights()) << "a time trial that was given up";
  EXPECT_EQ(words_on_course(result), "9 pieces cut, 1:20");
}

TEST(HudState, own_losses_are_no_clean_cuts_and_points_fly_from_their_place) {
  Match match({test::flat_rules(1, 1), 1, Difficulty::kNormal});
  HudState hud;
  const auto tell = [&](Event event) {
    const_cast<std::vector<Event>&>(match.events()) = {event};
    hud.on_tick(match);
  };
  tell({Event::Kind::kCleanPart, Match::kPlayer, 1});
  EXPECT_TRUE(hud.notices().empty());
  tell({Event::Kind::kRighted, Match::kPlayer, Event::kNobody, 0});
  EXPECT_EQ(hud.notices().front().text, "Freed");
  tell({Event::Kind::kRighted, Match::kPlayer, Event::kNobody, Event::kFlipped});
  EXPECT_EQ(hud.notices().front().text, "Flipped upright");
  tell({Event::Kind::kNotSpawned, Match::kPlayer, Event::kNobody, 0});
  EXPECT_EQ(hud.notices().front().text, "No room for another car");
  tell({Event::Kind::kNotSpawned, Match::kPlayer, Event::kNobody, 8});
  EXPECT_EQ(hud.notices().front().text, "Limit of 8 other cars reached");
  Event wheel{Event::Kind::kWheelLost, 1, Match::kPlayer};
  wheel.at = {1, 2, 3};
  wheel.points = 100;
  tell(wheel);
  wheel.kind = Event::Kind::kCleanPart;
  wheel.points = 50;
  tell(wheel);
  ASSERT_EQ(hud.points().size(), 1u);
  EXPECT_EQ(hud.points().front().points, 150);
  EXPECT_EQ(hud.points().front().at, Vec3(1, 2, 3));
}

TEST(WheelName, is_unique_and_readable) {
  const VehicleDescription& what = test::hatchback()->description;
  std::set<std::string> names;
  for (size_t i = 0; i < what.wheels.size(); ++i) names.insert(name_of_wheel(what, i));
  EXPECT_TRUE(names.contains("front left wheel"));
  EXPECT_EQ(names.size(), what.wheels.size());
}

}  // namespace
}  // namespace kerf
