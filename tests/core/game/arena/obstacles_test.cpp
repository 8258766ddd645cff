#include <gtest/gtest.h>

#include <cmath>

#include "core/base/deterministic_math.h"
#include "core/base/random.h"
#include "core/game/match/match.h"
#include "tests/support/checkout.h"
#include "tests/support/game_files.h"

namespace kerf {
namespace {

// The standard rules without enemies, the player standing somewhere else.
std::shared_ptr<Rules> alone_at(const Start& start) {
  static const auto loaded = load_rules(test::checkout() / "assets/games/standard.json");
  EXPECT_TRUE(loaded) << loaded.error().message;
  auto rules = std::make_shared<Rules>(**loaded);
  rules->waves.clear();
  rules->arena.description.player = start;
  return rules;
}

void drive(Match& match, int throttle, int steer, double seconds) {
  Controls controls;
  controls.throttle = static_cast<int8_t>(throttle);
  controls.steer = static_cast<int8_t>(steer);
  for (int t = 0; t < seconds * static_cast<double>(kTicksPerSecond); ++t) match.tick(controls);
}

Vec3 place_of(const Match& match) {
  return match.world().body(match.vehicles()[0].chassis).placement.position;
}

TEST(Obstacles, a_vehicle_that_hits_a_round_column_stops_and_can_drive_away) {
  Random random(7);
  const Vec3 column(18, 0, -15);
  for (int i = 0; i < 40; ++i) {
    const double heading = random.uniform(-kPi, kPi), aside = random.uniform(-0.9, 0.9);
    const Vec3 way = direction_of(heading, 0), across(way.z, 0, -way.x);
    Match match({alone_at({column - 4.8 * way + aside * across, heading}), 1, Difficulty::kNormal});
    drive(match, 100, 0, 2.5);
    const Vec3 stopped = place_of(match);
    ASSERT_GT(glm::distance(stopped, column), 0.8) << "approach " << i << " of seed 7 is in the column";
    drive(match, -100, static_cast<int>(random.below(201)) - 100, 3);
    ASSERT_GT(glm::distance(place_of(match), stopped), 1.5) << "approach " << i << " of seed 7 is stuck";
  }
}

TEST(Obstacles, drums_do_not_stop_a_vehicle) {
  Match match({alone_at({{-9, 0, -11.85}, kPi / 2}), 1, Difficulty::kNormal});
  drive(match, 100, 0, 4);
  EXPECT_GT(place_of(match).x, 4);
}

TEST(Obstacles, a_vehicle_drives_over_a_ramp_and_not_through_its_side) {
  Match over({alone_at({{-29, 0, 0}, kPi / 2}), 1, Difficulty::kNormal});
  double highest = 0;
  for (int i = 0; i < 40; ++i) {
    drive(over, 60, 0, 0.1);
    highest = std::max(highest, place_of(over).y);
  }
  EXPECT_GT(highest, 2) << "the ramp of the bridge";
  Match against({alone_at({{-14, 0, 10}, kPi}), 1, Difficulty::kNormal});
  drive(against, 60, 0, 3);
  EXPECT_GT(place_of(against).z, 3.5) << "the side of the ramp";
}

}  // namespace
}  // namespace kerf
