#include "ui/game/match_words.h"

#include <gtest/gtest.h>

#include <set>

#include "tests/support/game_files.h"

namespace kerf {
namespace {

TEST(WhyItEnded, is_the_time_where_nobody_was_hit) {
  auto rules = std::make_shared<Rules>(*test::flat_rules(1, 1));
  rules->description.times.match = 0.1;
  for (EnemySkill& skill : rules->description.skills) skill.speed = skill.fire = 0;
  Match match({rules, 1, Difficulty::kNormal});
  while (!match.standing().over()) match.tick({});
  EXPECT_EQ(why_it_ended(match), "Time is up");
}

TEST(NameOfWheel, is_that_of_its_part_in_words) {
  const VehicleDescription& what = test::hatchback()->description;
  std::set<std::string> names;
  for (size_t i = 0; i < what.wheels.size(); ++i) names.insert(name_of_wheel(what, i));
  EXPECT_TRUE(names.contains("front left wheel"));
  EXPECT_EQ(names.size(), what.wheels.size());
}

}  // namespace
}  // namespace kerf
