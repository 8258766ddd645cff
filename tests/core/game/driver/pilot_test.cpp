#include "core/game/driver/pilot.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "core/base/deterministic_math.h"
#include "core/base/ids.h"
#include "core/game/vehicle/vehicle.h"
#include "tests/core/game/driver/duel.h"

namespace kerf {
namespace {

constexpr int kTicksASecond = static_cast<int>(kTicksPerSecond);

PilotSkill exact(double reaction) {
  PilotSkill skill;
  skill.aiming.error = 0;
  skill.reaction = reaction;
  return skill;
}

// A driver between an opponent ahead, at 15 m, and one to the left, at 20 m.
class PilotTest : public testing::Test {
 protected:
  Controls drive(Pilot& pilot, int ticks) {
    Controls controls;
    for (int t = 0; t < ticks; ++t) controls = pilot.drive(duel_.view());
    return controls;
  }
  void put(size_t vehicle, const Vec3& place) {
    duel_.chassis(vehicle).placement.position = place;
    place_carried(duel_.world(), duel_.vehicle(vehicle));
  }
  // Whether the laser points at a heading; slashes and parts are within a quarter of a radian.
  static bool aims_at(const Controls& controls, double heading) {
    return std::abs(wrapped(controls.heading * Controls::kAimStep - heading)) < 0.25;
  }

  static constexpr double kAhead = 0, kLeft = kPi / 2;
  test::Duel duel_{std::array{Vec3(0), Vec3(0, 0, 15), Vec3(20, 0, 0)}};
};

TEST_F(PilotTest, fights_the_nearest_living_opponent) {
  Pilot pilot(1, exact(0));
  EXPECT_TRUE(aims_at(drive(pilot, 5), kAhead));
  duel_.vehicle(1).alive = false;
  EXPECT_TRUE(aims_at(drive(pilot, 5), kLeft)) << "at once";
}

TEST_F(PilotTest, switches_to_another_opponent_only_if_it_is_much_nearer) {
  Pilot pilot(1, exact(0));
  drive(pilot, 5);
  put(2, {12, 0, 0});
  EXPECT_TRUE(aims_at(drive(pilot, 2 * kTicksASecond), kAhead));
  put(2, {9, 0, 0});
  EXPECT_TRUE(aims_at(drive(pilot, 2 * kTicksASecond), kLeft));
}

TEST_F(PilotTest, releases_all_controls_without_an_opponent) {
  Pilot pilot(1, exact(0));
  drive(pilot, kTicksASecond);
  duel_.vehicle(1).alive = duel_.vehicle(2).alive = false;
  const Controls controls = drive(pilot, 1);
  EXPECT_TRUE(controls.throttle == 0 && controls.steer == 0);
  EXPECT_FALSE(controls.fire || controls.handbrake);
}

TEST_F(PilotTest, sees_its_opponent_with_its_reaction_delay) {
  Pilot pilot(1, exact(0.5));
  drive(pilot, kTicksASecond);
  put(1, {-15, 0, 0});
  EXPECT_TRUE(aims_at(drive(pilot, kTicksASecond / 2 - 1), kAhead));
  EXPECT_TRUE(aims_at(drive(pilot, 2), -kLeft));
}

TEST_F(PilotTest, extrapolates_with_the_last_seen_velocity) {
  Pilot pilot(1, exact(0.5));
  duel_.chassis(1).motion.velocity = {30, 0, 0};
  EXPECT_TRUE(aims_at(drive(pilot, kTicksASecond), std::atan2(30 * 0.5, 15)));
}

TEST_F(PilotTest, is_deterministic_per_seed) {
  Pilot first(7, PilotSkill{}), same(7, PilotSkill{});
  const Controls c = drive(first, 3 * kTicksASecond);
  EXPECT_EQ(drive(same, 3 * kTicksASecond), c);
}

}  // namespace
}  // namespace kerf
