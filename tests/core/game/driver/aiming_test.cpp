#include "core/game/driver/pilot.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "core/base/deterministic_math.h"
#include "core/game/vehicle/vehicle.h"
#include "tests/core/game/driver/duel.h"
#include "tests/support/sheets.h"

namespace kerf {
namespace {

// One that neither errs nor pauses.
AimingSkill perfect() {
  AimingSkill skill;
  skill.error = 0;
  skill.burst = 1000;
  skill.range = 40;
  return skill;
}

class AimingTest : public testing::Test {
 protected:
  // The controls after so many ticks in which the turret follows them.
  Controls aim(Aiming& aiming, int ticks) {
    Vehicle& own = duel_.vehicle(0);
    for (int t = 0; t < ticks; ++t) {
      aiming.aim(duel_.view(), 1, duel_.chassis(1).placement, own.controls);
      duel_.turn_turret();
    }
    return own.controls;
  }
  void move_opponent(const Vec3& to) {
    duel_.chassis(1).placement.position = to;
    place_carried(duel_.world(), duel_.vehicle(1));
  }
  // How far the line of aim passes a point, m.
  double miss(const Controls& controls, const Vec3& p) {
    const Vec3 from = duel_.chassis(0).placement.to_world(duel_.vehicle(0).what().turret.barrel.pivot);
    const Vec3 way = direction_of(controls.heading * Controls::kAimStep, controls.pitch * Controls::kAimStep);
    return glm::length(glm::cross(p - from, way));
  }

  test::Duel duel_{std::array{Vec3(0), Vec3(12, 0, 16)}};
};

TEST_F(AimingTest, sweeps_across_the_targeted_part) {
  // Nothing but the turret is left.
  Vehicle& opponent = duel_.vehicle(1);
  for (Wheel& wheel : opponent.wheels) wheel.attached = false;
  opponent.vital_works.assign(opponent.vital_works.size(), false);
  const Vec3 turret = duel_.chassis(1).placement.to_world(opponent.what().turret.pivot);
  Aiming aiming(1, perfect());
  double nearest = 1e9, farthest = 0;
  for (int t = 0; t < 400; ++t) {
    const double passes = miss(aim(aiming, 1), turret);
    nearest = std::min(nearest, passes);
    farthest = std::max(farthest, passes);
  }
  EXPECT_LT(nearest, 0.02);
  EXPECT_GT(farthest, 0.5);
  EXPECT_LT(farthest, 0.61);
}

TEST_F(AimingTest, is_deterministic_per_seed) {
  AimingSkill skill;
  Aiming first(3, skill), same(3, skill), other(4, skill);
  const Controls c = aim(first, 200);
  EXPECT_EQ(aim(same, 200), c);
  EXPECT_FALSE(aim(other, 200) == c);
}

TEST_F(AimingTest, has_the_error_of_its_skill) {
  AimingSkill skill = perfect();
  skill.error = 0.1;
  Aiming exact(5, perfect()), erring(5, skill);
  double sum = 0;
  constexpr int kTicks = 10'000;
  for (int t = 0; t < kTicks; ++t) {
    Controls a, b;
    exact.aim(duel_.view(), 1, duel_.chassis(1).placement, a);
    erring.aim(duel_.view(), 1, duel_.chassis(1).placement, b);
    const double off = (b.heading - a.heading) * Controls::kAimStep;
    sum += off * off;
  }
  EXPECT_NEAR(std::sqrt(sum / kTicks), 0.1, 0.03);
}

TEST_F(AimingTest, fires_when_the_barrel_is_on_target_and_in_range) {
  Aiming aiming(1, perfect());
  EXPECT_FALSE(aim(aiming, 1).fire) << "the barrel points ahead";
  EXPECT_TRUE(aim(aiming, 120).fire);
  move_opponent({0, 0, 45});
  EXPECT_FALSE(aim(aiming, 120).fire);
}

TEST_F(AimingTest, holds_fire_behind_a_wall_and_without_a_laser) {
  Aiming aiming(1, perfect());
  ASSERT_TRUE(aim(aiming, 120).fire);
  duel_.wall = test::add(duel_.world(), test::rectangle(20, 20, 2), {6, 0, 8},
                         axis_angle({0, 1, 0}, std::atan2(12, 16)) * axis_angle({1, 0, 0}, kPi / 2));
  EXPECT_FALSE(aim(aiming, 60).fire);
  duel_.wall.reset();
  EXPECT_TRUE(aim(aiming, 60).fire) << "a body that is no wall is cut";
  duel_.vehicle(0).gun.barrel_attached = false;
  Controls controls = duel_.vehicle(0).controls;
  aiming.aim(duel_.view(), 1, duel_.chassis(1).placement, controls);
  EXPECT_FALSE(controls.fire);
}

TEST_F(AimingTest, fires_in_bursts_with_pauses) {
  AimingSkill skill = perfect();
  skill.burst = 0.5;
  skill.pause = 1.5;
  Aiming aiming(1, skill);
  aim(aiming, 120);
  int firing = 0;
  for (int t = 0; t < 4800; ++t) firing += aim(aiming, 1).fire;
  EXPECT_NEAR(firing / 4800.0, 0.25, 0.06);
}

}  // namespace
}  // namespace kerf
