#include "ui/game/sighted_part.h"

#include <gtest/gtest.h>

#include <set>

#include "core/game/vehicle/vehicle_bodies.h"
#include "tests/support/game_files.h"

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

TEST_F(TwoVehicles, the_wheel_that_is_seen_is_named) {
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

TEST_F(TwoVehicles, beside_the_enemy_there_is_no_part) {
  EXPECT_FALSE(aim_at({0, 40, 0}));
  EXPECT_FALSE(aim_at({0, -20, 0}));  // the ground before it
}

TEST_F(TwoVehicles, nothing_is_in_sight_beyond_the_range_of_the_laser) {
  auto rules = std::make_shared<Rules>(match_.rules());
  rules->description.laser.range = 1;
  match_ = Match({rules, 1, Difficulty::kNormal});
  EXPECT_FALSE(aim_at(what().turret.barrel.pivot));
}

TEST_F(TwoVehicles, an_enemy_in_the_open_is_seen) {
  const Sight sight(match_.world());
  EXPECT_TRUE(sees_vehicle(match_, sight, {0, 2, 0}, 1));
}

}  // namespace
}  // namespace kerf
