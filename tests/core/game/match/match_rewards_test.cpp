#include <gtest/gtest.h>

#include <algorithm>
#include <optional>

#include "core/base/deterministic_math.h"
#include "core/base/ids.h"
#include "core/game/match/match.h"
#include "tests/support/game_files.h"

namespace kerf {
namespace {

// A match whose one enemy stands still, a wave of it after the other.
std::shared_ptr<const Rules> quiet_rules(size_t waves) {
  auto rules = std::make_shared<Rules>(*test::flat_rules(waves, 1));
  for (EnemySkill& skill : rules->description.skills) skill.speed = skill.fire = 0;
  return rules;
}

Vehicle& vehicle(Match& match, size_t index) { return const_cast<Vehicle&>(match.vehicles()[index]); }
World& world(Match& match) { return const_cast<World&>(match.world()); }

void pass(Match& match, double seconds, const Controls& controls = {}) {
  const auto ticks = static_cast<Ticks>(seconds * static_cast<double>(kTicksPerSecond));
  for (Ticks t = 0; t < ticks; ++t) match.tick(controls);
}

// The enemy is changed behind the back of the match, as no beam does it so quickly.
void end_wave(Match& match) {
  vehicle(match, 1).alive = false;
  match.tick({});
}

TEST(Upgrades, one_of_three_is_selected_between_two_waves_and_stays) {
  Match match({quiet_rules(3), 1, Difficulty::kNormal});
  Controls selects;
  selects.upgrade = static_cast<uint8_t>(Upgrade::kArmour);
  match.tick(selects);
  EXPECT_FALSE(match.has_upgraded()) << "not during a wave";
  end_wave(match);
  match.tick(selects);
  selects.upgrade = static_cast<uint8_t>(Upgrade::kCooling);
  match.tick(selects);
  EXPECT_TRUE(match.has_upgraded());
  EXPECT_EQ(match.standing().upgrades, (std::array<uint8_t, 3>{0, 0, 1})) << "one for each pause";
  while (match.standing().phase == Standing::Phase::kPause) match.tick({});
  EXPECT_LT(match.vehicles()[0].min_vital, kMinPart);
  EXPECT_EQ(match.vehicles()[1].min_vital, kMinPart);
}

TEST(Boost, is_used_up_while_it_is_held_and_refills) {
  Match match({quiet_rules(1), 1, Difficulty::kNormal});
  Controls controls;
  controls.throttle = Controls::kFull;
  pass(match, 0.5, controls);
  EXPECT_EQ(match.vehicles()[0].boost, 1);
  controls.boost = true;
  pass(match, 1.5, controls);
  const double used = match.vehicles()[0].boost;
  EXPECT_LT(used, 0.5);
  pass(match, 1);
  EXPECT_GT(match.vehicles()[0].boost, used);
}

TEST(Jump, scores_its_time_in_the_air) {
  auto rules = std::make_shared<Rules>(*quiet_rules(1));
  rules->description.scores.air = 100;
  Match match({rules, 1, Difficulty::kNormal});
  pass(match, 1);
  EXPECT_EQ(match.standing().score, 0);
  world(match).body(match.vehicles()[0].chassis).motion.velocity.y += 5;
  std::optional<Event> jump;
  for (int t = 0; t < 240; ++t) {
    match.tick({});
    for (const Event& e : match.events()) {
      if (e.kind == Event::Kind::kJumped) jump = e;
    }
  }
  ASSERT_TRUE(jump);
  EXPECT_NEAR(jump->size, 1, 0.3);
  EXPECT_EQ(match.standing().score, jump->points);
}

TEST(Jump, scores_nothing_for_a_car_that_turns_over_in_the_air) {
  auto rules = std::make_shared<Rules>(*quiet_rules(1));
  rules->description.scores.air = 100;
  Match match({rules, 1, Difficulty::kNormal});
  pass(match, 1);
  const auto chassis = [&]() -> Body& { return world(match).body(match.vehicles()[0].chassis); };
  chassis().motion.velocity.y += 8;
  pass(match, 1);
  Placement& placement = chassis().placement;
  placement.orientation = axis_angle({0, 0, 1}, 0.5 * kPi) * placement.orientation;
  pass(match, 0.25);
  EXPECT_EQ(match.standing().score, 0);
}

TEST(Jump, does_not_include_the_time_of_a_car_that_is_caught_off_the_ground) {
  auto rules = std::make_shared<Rules>(*quiet_rules(1));
  rules->description.scores.air = 100;
  Match match({rules, 1, Difficulty::kNormal});
  pass(match, 1);
  const auto chassis = [&]() -> Body& { return world(match).body(match.vehicles()[0].chassis); };
  Placement caught = chassis().placement;
  caught.position.y += 1.5;
  Controls forward;
  forward.throttle = Controls::kFull;
  bool righted = false;
  for (int t = 0; t < 1200 && !righted; ++t) {
    chassis().placement = caught;
    chassis().motion = {};
    match.tick(forward);
    righted = std::ranges::count(match.events(), Event::Kind::kRighted, &Event::kind) > 0;
  }
  ASSERT_TRUE(righted);
  double longest = 0;
  for (int t = 0; t < 240; ++t) {
    match.tick({});
    for (const Event& e : match.events())
      longest = std::max(longest, e.kind == Event::Kind::kJumped ? e.size : 0);
  }
  EXPECT_LT(longest, 2) << "it was caught for longer, and fell for less than a second";
}

TEST(Wheel, a_replaced_one_holds_without_its_mount) {
  test::LoneVehicle stage;
  Wheel& wheel = stage.vehicle.wheels[0];
  wheel.attached = false;
  const BodyId lost = wheel.body;
  Delta change;
  replace_wheel(stage.world, stage.vehicle, 0, 0, change);
  EXPECT_TRUE(wheel.attached);
  EXPECT_NE(wheel.body, lost);
  EXPECT_EQ(change.created, std::vector{wheel.body});
  EXPECT_TRUE(assess_damage(stage.world, stage.vehicle).wheels.empty());
}

}  // namespace
}  // namespace kerf
