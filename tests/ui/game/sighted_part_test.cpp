#include "ui/game/player_input.h"

#include <gtest/gtest.h>

#include <algorithm>

#include <set>

#include "core/base/random.h"
#include "core/game/vehicle/vehicle.h"
#include "tests/support/checkout.h"
#include "tests/support/game_files.h"
#include "tests/support/segment_faces.h"

namespace kerf {
namespace {

// A match of two vehicles on flat ground, which stand still.
class TwoVehicles : public testing::Test {
 protected:
  // What the player sees who aims at a place of the enemy (m, in the frame of its chassis).
  std::optional<SightedPart> aim_at(const Vec3& place) const {
    const Vehicle& own = match_.vehicles()[Match::kPlayer];
    const Vec3 from = in_world(match_.world(), own, own.what().turret.barrel.pivot);
    const Vec3 to = match_.world().body(match_.vehicles()[1].chassis).placement.to_world(place);
    return sighted_part(match_, Sight(match_.world()), glm::normalize(to - from));
  }
  const VehicleDescription& what() const { return match_.vehicles()[1].what(); }

  Match match_{{test::flat_rules(1, 1), 1, Difficulty::kNormal}};
};

TEST_F(TwoVehicles, a_visible_wheel_is_named) {
  std::set<std::string> names;
  for (const WheelDescription& wheel : what().wheels) {
    const auto part = aim_at(wheel.hub);
    ASSERT_TRUE(part);
    EXPECT_EQ(part->vehicle, 1u);
    if (part->body == match_.vehicles()[1].chassis) continue;  // it hides the wheel
    EXPECT_TRUE(part->name.ends_with(" wheel")) << part->name;
    names.insert(part->name);
  }
  EXPECT_GE(names.size(), 1u);
}

TEST_F(TwoVehicles, the_turret_is_the_laser) {
  const auto part = aim_at(what().turret.barrel.pivot);
  ASSERT_TRUE(part);
  EXPECT_EQ(part->name, "laser");
}

TEST_F(TwoVehicles, there_is_no_part_next_to_the_enemy) {
  EXPECT_FALSE(aim_at({0, 40, 0}));
  EXPECT_FALSE(aim_at({0, -20, 0}));  // the ground before it
}

TEST_F(TwoVehicles, nothing_is_visible_beyond_the_laser_range) {
  auto rules = std::make_shared<Rules>(match_.rules());
  rules->description.laser.range = 1;
  match_ = Match({rules, 1, Difficulty::kNormal});
  EXPECT_FALSE(aim_at(what().turret.barrel.pivot));
}

TEST_F(TwoVehicles, an_enemy_in_the_open_is_visible) {
  const Sight sight(match_.world());
  EXPECT_TRUE(sees_vehicle(match_, sight, {0, 2, 0}, 1));
}

TEST_F(TwoVehicles, a_beam_ends_at_a_hit_or_at_its_range) {
  const Sight sight(match_.world());
  const Vehicle& own = match_.vehicles()[Match::kPlayer];
  const Vec3 from = in_world(match_.world(), own, own.what().turret.barrel.pivot);
  const double range = match_.rules().description.laser.range;
  EXPECT_NEAR(glm::distance(place_aimed_at(match_, sight, {0, 1, 0}), from), range, 1e-9) << "the sky";
  const Vec3 down = place_aimed_at(match_, sight, glm::normalize(Vec3(1, -1, 0)));
  EXPECT_NEAR(down.y, 0, 1e-9) << "the ground";
  const Vec3 enemy = match_.world().body(match_.vehicles()[1].chassis).placement.to_world({0, 0.8, 0});
  const Vec3 at = place_aimed_at(match_, sight, glm::normalize(enemy - from));
  EXPECT_LT(glm::distance(at, enemy), 3);
  EXPECT_LT(glm::distance(at, from), glm::distance(enemy, from));
}

// Whether a wall crosses the way between two points (m).
bool is_walled(const Match& match, const Vec3& from, const Vec3& to) {
  return std::ranges::any_of(match.world().ids(), [&](BodyId id) {
    return match.is_wall(id) && test::crosses(match.world().body(id), from, to);
  });
}

TEST(SeesVehicle, matches_a_search_of_all_faces_for_blocking_walls) {
  const auto rules = load_rules(test::checkout() / "assets/games/standard.json");
  ASSERT_TRUE(rules) << rules.error().message;
  const Match match({*rules, 1, Difficulty::kNormal});
  const Sight sight(match.world());
  const Vec3 middle = match.world().body(match.vehicles()[1].chassis).placement.to_world({0, 0.8, 0});
  const Vec2 size = (*rules)->arena.description.size;
  Random random(7);
  int seen = 0, hidden = 0;
  for (int i = 0; i < 200; ++i) {
    const Vec3 from(random.uniform(-0.4, 0.4) * size.x, random.uniform(0.5, 4),
                    random.uniform(-0.4, 0.4) * size.y);
    const bool sees = sees_vehicle(match, sight, from, 1);
    EXPECT_NE(sees, is_walled(match, from, middle)) << "from " << from.x << " " << from.y << " " << from.z;
    ++(sees ? seen : hidden);
  }
  EXPECT_GT(seen, 10);
  EXPECT_GT(hidden, 10);
}

}  // namespace
}  // namespace kerf
