#include <gtest/gtest.h>

#include <algorithm>
#include <functional>

#include "core/base/deterministic_math.h"
#include "core/base/ids.h"
#include "core/game/match/match.h"
#include "tests/support/checkout.h"
#include "tests/support/game_files.h"

namespace kerf {
namespace {

constexpr double kPropAway = 8;  // m

// Prop `name` of the yard.
ArenaBody prop(const std::string& name) {
  const auto yard = read_arena(test::checkout() / "assets/arenas/yard.json");
  const auto found =
      std::ranges::find(yard->bodies, name, [](const ArenaBody& body) { return body.body.name; });
  return *found;
}

// A prop ahead of the player, and an enemy that stands still.
std::shared_ptr<const Rules> rules_with(const std::string& name, double height, const Start& enemy) {
  auto rules = std::make_shared<Rules>(*test::flat_rules(1, 1));
  for (EnemySkill& skill : rules->description.skills) skill.speed = skill.fire = 0;
  ArenaDescription arena = rules->arena.description;
  arena.enemies = {enemy, enemy};
  ArenaBody& body = arena.bodies.emplace_back(prop(name));
  body.body.placement = {{0, height, kPropAway}, {1, 0, 0, 0}};
  rules->arena = *load_arena(std::move(arena));
  return rules;
}

std::shared_ptr<const Rules> rules_with_post(const Start& enemy) {
  return rules_with("lamp_post_1", 0, enemy);
}

// The highest point of the prop and of its parts [m].
double top_of_prop(const Match& match) {
  double top = 0;
  for (const BodyId id : match.world().ids()) {
    const Body& body = match.world().body(id);
    const bool of_vehicle = std::ranges::any_of(
        match.vehicles(), [&](const Vehicle& vehicle) { return vehicle.is_made_of(body); });
    if (of_vehicle) continue;
    for (uint32_t f = 0; f < body.mesh.face_slots(); ++f) {
      if (!body.mesh.is_live(FaceId(f))) continue;
      for (const Vec3& corner : body.mesh.triangle(FaceId(f)))
        top = std::max(top, body.placement.to_world(corner).y);
    }
  }
  return top;
}

// What the player's beam did.
struct Course {
  std::vector<Event> struck, burst;
  double score = 0;
};

void record(const Match& match, Course& course) {
  for (const Event& event : match.events()) {
    if (event.kind == Event::Kind::kStruck) course.struck.push_back(event);
    if (event.kind == Event::Kind::kTankBurst) course.burst.push_back(event);
  }
  course.score = match.standing().score;
}

// Aims for half a second at a place that may move [m], and then sweeps the beam across it in a second, from
// one angle to another [rad], about the vertical.
void sweep(Match& match, const std::function<Vec3()>& place, double from, double to, Course& course) {
  const Vehicle& own = match.vehicles()[Match::kPlayer];
  Controls controls;
  controls.width = 50;
  constexpr int kSecond = static_cast<int>(kTicksPerSecond);
  for (int t = -kSecond / 2; t < kSecond; ++t) {
    const double share = std::max(0, t) / double{kSecond};
    const Vec3 way = place() - in_world(match.world(), own, own.what().turret.barrel.pivot);
    controls.heading =
        static_cast<int32_t>((heading_of(way) + from + share * (to - from)) / Controls::kAimStep);
    controls.pitch = static_cast<int32_t>(pitch_of(way) / Controls::kAimStep);
    controls.fire = t > 0;
    match.tick(controls);
    record(match, course);
  }
}

// Cuts the post 1.6 m above the ground.
void cut_post(Match& match, Course& course) {
  sweep(
      match, [] { return Vec3(0, 1.6, kPropAway); }, -0.06, 0.06, course);
}

void pass(Match& match, double seconds, Course& course) {
  for (Ticks t = 0; t < static_cast<Ticks>(seconds * kTicksPerSecond); ++t) {
    match.tick({});
    record(match, course);
  }
}

TEST(LampPost, stands_until_its_foot_is_cut_and_then_falls) {
  Match match({rules_with_post({{0, 0, 60}, 0}), 1, Difficulty::kNormal});
  Course course;
  pass(match, 2, course);
  EXPECT_GT(top_of_prop(match), 6.8);
  cut_post(match, course);
  pass(match, 4, course);
  EXPECT_LT(top_of_prop(match), 3);
  EXPECT_TRUE(course.struck.empty());
}

TEST(LampPost, that_falls_on_an_enemy_scores_and_takes_parts_off_it) {
  // It falls in the direction of the stroke.
  Match match({rules_with_post({{3.2, 0, kPropAway}, 0}), 1, Difficulty::kNormal});
  Course course;
  cut_post(match, course);
  pass(match, 4, course);
  ASSERT_EQ(course.struck.size(), 1u);
  EXPECT_EQ(course.struck[0].vehicle, 1u);
  EXPECT_EQ(course.struck[0].by, Match::kPlayer);
  EXPECT_EQ(course.struck[0].points, match.rules().description.scores.struck);
  EXPECT_GE(course.score, 800);
  const Vehicle& enemy = match.vehicles()[1];
  EXPECT_TRUE(!enemy.gun.works() || enemy.wheels_attached() < 4 || enemy.whole < 0.99);
}

TEST(LampPost, that_falls_past_an_enemy_does_not_strike_it) {
  Match match({rules_with_post({{-4, 0, kPropAway}, 0}), 1, Difficulty::kNormal});
  Course course;
  cut_post(match, course);
  pass(match, 4, course);
  EXPECT_TRUE(course.struck.empty());
  EXPECT_TRUE(match.vehicles()[1].gun.works());
}

// Cuts one leg of a gantry after the other, which stands at an angle to the view; returns its highest point 4
// s later.
double top_of_cut_gantry(double yaw, double height, double sweep_by) {
  Rules rules = *rules_with("gantry_1", 0, {{0, 0, 60}, 0});
  ArenaDescription arena = rules.arena.description;
  arena.bodies.back().body.placement.orientation = glm::angleAxis(yaw, Vec3(0, 1, 0));
  rules.arena = *load_arena(std::move(arena));
  Match match({std::make_shared<Rules>(std::move(rules)), 1, Difficulty::kNormal});
  Course course;
  for (const double leg : {-4.04, 4.04}) {
    const Vec3 at(leg * std::cos(yaw), height, kPropAway - leg * std::sin(yaw));
    sweep(
        match, [&] { return at; }, -sweep_by, sweep_by, course);
  }
  pass(match, 4, course);
  return top_of_prop(match);
}

// Its legs stand 8 m apart, so it can tip over only across its length.
TEST(Gantry, falls_when_both_legs_are_cut) {
  for (const double yaw : {0.0, 0.4, 0.8, 1.1}) {
    for (const double height : {0.5, 1.2, 2.2}) {
      for (const double sweep_by : {-0.09, 0.09}) {
        EXPECT_LT(top_of_cut_gantry(yaw, height, sweep_by), 3)
            << "turned by " << yaw << ", cut at " << height << " m, swept by " << sweep_by;
      }
    }
  }
}

TEST(FuelTank, bursts_once_when_a_beam_cuts_it_and_overheats_the_laser) {
  Match match({rules_with_post({{-9, 0, 0}, 0}), 1, Difficulty::kNormal});
  const Vehicle& enemy = match.vehicles()[1];
  Course course;
  pass(match, 1, course);
  EXPECT_TRUE(course.burst.empty());
  const auto tank = [&] { return in_world(match.world(), enemy, enemy.model->tank_centre); };
  sweep(match, tank, 0.02, -0.02, course);
  pass(match, 0.5, course);
  ASSERT_EQ(course.burst.size(), 1u);
  EXPECT_EQ(course.burst[0].vehicle, 1u);
  EXPECT_GE(course.burst[0].points, match.rules().description.scores.tank);
  EXPECT_FALSE(enemy.tank_whole);
  EXPECT_TRUE(enemy.gun.overheated || !enemy.gun.works());
  EXPECT_FALSE(match.vehicles()[0].gun.overheated) << "it is 9 m away";
}

TEST(Damage, of_a_fuel_tank_is_reported_once) {
  test::LoneVehicle lone;
  const Vec3 tank = lone.vehicle.model->tank_centre;
  EXPECT_FALSE(assess_damage(lone.world, lone.vehicle).tank);
  lone.cut({{tank.x - 0.1, 2, tank.z}, {0, -1, 0}}, {{tank.x + 0.1, 2, tank.z}, {0, -1, 0}}, 0.03, 2.2);
  EXPECT_TRUE(assess_damage(lone.world, lone.vehicle).tank);
  EXPECT_FALSE(assess_damage(lone.world, lone.vehicle).tank);
  EXPECT_TRUE(lone.vehicle.alive);
}

TEST(KnockOff, takes_the_parts_near_a_place) {
  test::LoneVehicle lone;
  const Vec3 hub = lone.vehicle.what().wheels[2].hub;
  const Damage wheel = knock_off(lone.world, lone.vehicle, hub, 0.5);
  EXPECT_EQ(wheel.wheels, std::vector<size_t>{2});
  EXPECT_FALSE(wheel.turret);
  EXPECT_EQ(lone.vehicle.wheels_attached(), 3u);
  const Damage laser = knock_off(lone.world, lone.vehicle, lone.vehicle.what().turret.pivot, 0.2);
  EXPECT_TRUE(laser.turret && laser.wheels.empty());
  EXPECT_FALSE(lone.vehicle.gun.works());
  EXPECT_FALSE(knock_off(lone.world, lone.vehicle, hub, 0.5).turret) << "each comes off once";
}

}  // namespace
}  // namespace kerf
