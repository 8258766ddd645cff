#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <set>

#include "core/base/deterministic_math.h"
#include "core/game/match/match.h"
#include "core/game/match/recording.h"
#include "core/world/world.h"
#include "tests/support/checkout.h"
#include "tests/support/game_files.h"

namespace kerf {
namespace {

using Phase = Standing::Phase;

// Waves of two enemies that neither drive nor fire, for a player with so many cars.
std::shared_ptr<Rules> quiet_waves(size_t waves, size_t cars) {
  auto rules = std::make_shared<Rules>(*test::flat_rules(waves, 2));
  rules->description.cars = cars;
  rules->description.times.between_waves = 0.1;
  for (EnemySkill& skill : rules->description.skills) skill.speed = skill.fire = 0;
  return rules;
}

// Puts a vehicle out of action behind the back of the match, as no beam does it so quickly.
void disable(const Match& match, size_t vehicle) {
  const_cast<Vehicle&>(match.vehicles()[vehicle]).alive = false;
}

void tick_until_fight(Match& match) {
  for (int t = 0; t < 60 && match.standing().phase != Phase::kFight; ++t) match.tick({});
}

TEST(Cars, a_wave_restarts_with_the_next_car_and_the_remaining_enemies) {
  Match match({quiet_waves(2, 3), 1, Difficulty::kNormal});
  EXPECT_EQ(match.standing().cars_left, 2u);
  disable(match, 1);
  disable(match, Match::kPlayer);
  match.tick({});
  EXPECT_EQ(match.standing().phase, Phase::kDown);
  EXPECT_EQ(match.standing().cars_left, 1u);
  EXPECT_FALSE(match.standing().over());
  tick_until_fight(match);
  ASSERT_EQ(match.vehicles().size(), 2u) << "the enemy that was out does not come back";
  EXPECT_TRUE(match.vehicles()[0].alive && match.vehicles()[1].alive);
  EXPECT_EQ(match.standing().wave, 0u);
  EXPECT_EQ(match.wave_start().out, std::vector<size_t>{0});
  disable(match, 1);
  match.tick({});
  EXPECT_EQ(match.standing().phase, Phase::kPause) << "the wave is cleared";
  tick_until_fight(match);
  EXPECT_EQ(match.standing().wave, 1u);
  EXPECT_EQ(match.vehicles().size(), 3u) << "the next wave is whole";
}

TEST(Cars, a_car_lost_with_the_last_enemy_still_advances_to_the_next_wave) {
  Match match({quiet_waves(2, 3), 1, Difficulty::kNormal});
  const auto all_out = [&] {
    for (size_t v = 0; v < match.vehicles().size(); ++v) disable(match, v);
    match.tick({});
  };
  all_out();
  EXPECT_EQ(match.standing().phase, Phase::kDown);
  tick_until_fight(match);
  EXPECT_EQ(match.standing().wave, 1u);
  EXPECT_EQ(match.vehicles().size(), 3u);
  all_out();
  for (int t = 0; t < 60 && !match.standing().over(); ++t) match.tick({});
  EXPECT_EQ(match.standing().phase, Phase::kWon);
}

TEST(Cars, the_match_is_lost_with_the_last_car) {
  Match match({quiet_waves(1, 2), 1, Difficulty::kNormal});
  disable(match, Match::kPlayer);
  match.tick({});
  tick_until_fight(match);
  EXPECT_EQ(match.standing().cars_left, 0u);
  disable(match, Match::kPlayer);
  match.tick({});
  EXPECT_EQ(match.standing().phase, Phase::kLost);
}

TEST(Cars, disabled_cars_are_given_up_one_at_a_time) {
  Match match({quiet_waves(1, 2), 1, Difficulty::kNormal});
  auto& own = const_cast<Vehicle&>(match.vehicles()[Match::kPlayer]);
  own.gun.turret_attached = false;
  for (Wheel& wheel : own.wheels) wheel.attached = false;
  Controls controls;
  controls.give_up = true;
  match.tick(controls);
  EXPECT_EQ(match.standing().phase, Phase::kDown);
}

// A player who stands before two enemies on hard loses his car soon.
TEST(Cars, the_match_resumes_exactly_from_the_start_of_the_next_car) {
  auto rules = std::make_shared<Rules>(*test::flat_rules(1, 2));
  rules->description.cars = 9;
  rules->description.times.between_waves = 0.1;
  rules->description.skills[2] = {0.1, 0.01, 0.8, 1, 8, 12};
  const MatchSetup setup{rules, 4, Difficulty::kHard};
  Match match(setup);
  const std::vector<Controls> controls(90 * kTicksPerSecond);
  size_t t = 0;
  while (t + 120 < controls.size() &&
         (match.standing().cars_left == 8 || match.standing().phase != Phase::kFight))
    match.tick(controls[t++]);
  ASSERT_EQ(match.standing().cars_left, 7u);
  const WaveStart start = match.wave_start();
  EXPECT_EQ(start.standing.ticks, t);
  for (int more = 0; more < 120; ++more) match.tick(controls[t++]);
  const auto again = match_at(setup, start, controls, t);
  EXPECT_EQ(state_hash(again->world()), state_hash(match.world()));
}

TEST(Targets, stand_still_and_the_match_ends_on_time_even_if_all_are_destroyed) {
  auto rules = std::make_shared<Rules>(*test::flat_rules(1, 1));
  rules->description.targets = true;
  rules->description.times.match = 2;
  Match match({rules, 1, Difficulty::kHard});
  const Vec3 place = match.world().body(match.vehicles()[1].chassis).placement.position;
  for (Ticks t = 0; t < kTicksPerSecond; ++t) {
    match.tick({});
    EXPECT_FALSE(match.vehicles()[1].gun.firing);
  }
  const Vec3 later = match.world().body(match.vehicles()[1].chassis).placement.position;
  EXPECT_LT(glm::length(Vec3(later.x - place.x, 0, later.z - place.z)), 0.05);
  disable(match, 1);
  match.tick({});
  EXPECT_EQ(match.standing().phase, Phase::kFight);
  while (!match.standing().over()) match.tick({});
  EXPECT_EQ(match.standing().phase, Phase::kEnded);
  EXPECT_EQ(match.standing().ticks, 2 * kTicksPerSecond);
}

TEST(Targets, that_are_all_destroyed_do_not_win_the_match_when_a_car_is_lost) {
  const auto rules = quiet_waves(1, 2);
  rules->description.targets = true;
  rules->description.times.match = 1;
  Match match({rules, 1, Difficulty::kNormal});
  for (size_t v = 0; v < match.vehicles().size(); ++v) disable(match, v);
  match.tick({});
  EXPECT_EQ(match.standing().phase, Phase::kDown);
  tick_until_fight(match);
  EXPECT_EQ(match.standing().phase, Phase::kFight);
  EXPECT_EQ(match.vehicles().size(), 1u) << "the targets do not come back";
  while (!match.standing().over()) match.tick({});
  EXPECT_EQ(match.standing().phase, Phase::kEnded);
}

std::shared_ptr<const Rules> sandbox() {
  auto rules = std::make_shared<Rules>(*test::flat_rules(0, 0));
  rules->spawns = {test::hatchback()};
  return rules;
}

Controls spawn_request(bool pressed) {
  Controls controls;
  controls.spawn = pressed;
  return controls;
}

TEST(Sandbox, a_vehicle_spawns_once_per_key_press) {
  Match match({sandbox(), 1, Difficulty::kNormal});
  for (int t = 0; t < 30; ++t) match.tick(spawn_request(true));
  EXPECT_EQ(match.vehicles().size(), 2u);
  for (int i = 0; i < 20; ++i) {
    match.tick(spawn_request(false));
    match.tick(spawn_request(true));
  }
  EXPECT_GT(match.vehicles().size(), 4u);
  EXPECT_LE(match.vehicles().size(), 9u);
  for (size_t i = 0; i < match.vehicles().size(); ++i) {
    for (size_t j = 0; j < i; ++j) {
      const auto at = [&](size_t v) {
        return match.world().body(match.vehicles()[v].chassis).placement.position;
      };
      EXPECT_GT(glm::distance(at(i), at(j)), 2) << i << " and " << j;
    }
  }
  const uint64_t hash = state_hash(match.world());
  Match again({sandbox(), 1, Difficulty::kNormal});
  for (int t = 0; t < 30; ++t) again.tick(spawn_request(true));
  for (int i = 0; i < 20; ++i) {
    again.tick(spawn_request(false));
    again.tick(spawn_request(true));
  }
  EXPECT_EQ(state_hash(again.world()), hash);
}

TEST(Sandbox, a_request_without_a_vehicle_is_reported_once) {
  Match match({sandbox(), 1, Difficulty::kNormal});
  const auto refusals = [&] {
    return std::ranges::count(match.events(), Event::Kind::kNotSpawned, &Event::kind);
  };
  for (size_t before = 0; before < match.vehicles().size();) {
    EXPECT_EQ(refusals(), 0);
    before = match.vehicles().size();
    match.tick(spawn_request(false));
    match.tick(spawn_request(true));
  }
  ASSERT_EQ(refusals(), 1);
  const auto refusal = std::ranges::find(match.events(), Event::Kind::kNotSpawned, &Event::kind);
  const bool is_full = match.vehicles().size() > Match::kMaxOthers;
  EXPECT_EQ(refusal->part, is_full ? Match::kMaxOthers : 0);
  match.tick(spawn_request(true));
  EXPECT_EQ(refusals(), 0) << "the key is held";
}

// No face of the arena crosses a line along the vehicle, in any place of the arena.
TEST(Sandbox, vehicles_spawn_between_walls) {
  const auto rules = load_rules(test::checkout() / "assets/games/standard.json");
  ASSERT_TRUE(rules) << rules.error().message;
  const FreeSpace space((*rules)->arena);
  std::mt19937 random(3);
  std::uniform_real_distribution<double> metres(-40, 40), turns(-kPi, kPi);
  size_t places = 0;
  for (int i = 0; i < 300; ++i) {
    const Placement from{{metres(random), 0, metres(random)}, axis_angle({0, 1, 0}, turns(random))};
    const auto place = place_before(from, space, {});
    if (!place) continue;
    ++places;
    const Pose line{place->to_world({0, 0.8, -1.9}), place->orientation * Vec3(0, 0, 1)};
    for (const ModelBody& fixed : (*rules)->arena.bodies) {
      const Body& body = fixed.body;
      if (!body.pinned) continue;
      EXPECT_FALSE(body.tree.nearest(body.mesh, body.placement.to_body(line), {0, 3.8}))
          << i << " at " << place->position.x << ", " << place->position.z;
    }
  }
  EXPECT_GT(places, 100u);
}

TEST(Sandbox, a_spawned_vehicle_can_be_cut) {
  Match match({sandbox(), 1, Difficulty::kNormal});
  match.tick(spawn_request(true));
  ASSERT_EQ(match.vehicles().size(), 2u);
  const std::vector<BodyId> before = match.world().ids();
  Controls controls;
  controls.fire = true;
  controls.width = 60;
  std::set<Event::Kind> kinds;
  for (int t = 0; t < 360; ++t) {
    controls.pitch = -1'500 - 4 * (t % 120);
    controls.heading = 3'000 - 50 * (t % 120);
    match.tick(controls);
    for (const Event& e : match.events()) {
      if (e.vehicle == 1) kinds.insert(e.kind);
    }
  }
  EXPECT_TRUE(kinds.contains(Event::Kind::kCut));
  EXPECT_TRUE(kinds.contains(Event::Kind::kPieceOff));
}

}  // namespace
}  // namespace kerf
