#include "core/physics/solver.h"

#include <gtest/gtest.h>

#include "core/base/ids.h"
#include "tests/core/physics/moving_sheets.h"
#include "tests/support/sheets.h"

namespace kerf {
namespace {

constexpr double kFall = 9.81 * kTick;  // m/s, what gravity adds in a tick

// A plate of two metres that may touch the ground at its four corners.
class SolvedPlate : public testing::Test {
 protected:
  SolvedPlate() { sheets_.add(test::rectangle(2, 2, 1), {0, 1, 0}); }
  Motion& motion() { return sheets_.body(0).motion; }
  void touch_ground(double distance) {
    TouchingPair pair{0, TouchingPair::kGround, {}, {}};
    for (const Vec3 corner : {Vec3(-1, 1, -1), Vec3(1, 1, -1), Vec3(-1, 1, 1), Vec3(1, 1, 1)})
      pair.contacts.push_back({corner, {0, 1, 0}, distance, pair.contacts.size(), {}});
    pairs_ = {pair};
  }
  void solve() {
    SolverSettings settings;
    settings.seconds = kTick;
    settings.gravity = {0, -9.81, 0};
    solve_contacts(sheets_.bodies(), pairs_, {}, settings, memory_);
  }
  double mass() { return sheets_.bodies()[0].frame.mass; }

  test::MovingSheets sheets_;
  std::vector<TouchingPair> pairs_;
  SolverMemory memory_;
};

TEST_F(SolvedPlate, falls_freely) {
  solve();
  EXPECT_NEAR(motion().velocity.y, -kFall, 0.002 * kFall);
  EXPECT_NEAR(sheets_.body(0).placement.position.y, 1 + kTick * motion().velocity.y, 1e-9);
}

TEST_F(SolvedPlate, is_supported_by_contact_impulses_equal_to_its_weight) {
  touch_ground(0);
  for (int i = 0; i < 10; ++i) solve();
  EXPECT_NEAR(motion().velocity.y, 0, 0.01 * kFall);
  double sum = 0;
  for (const Contact& c : pairs_[0].contacts) {
    EXPECT_GE(c.impulse[0], 0);
    sum += c.impulse[0];
  }
  EXPECT_NEAR(sum, mass() * kFall, 0.05 * mass() * kFall);
}

TEST_F(SolvedPlate, approaches_to_exactly_the_contact_distance) {
  motion().velocity = {0, -3, 0};
  touch_ground(0.01);
  solve();
  EXPECT_NEAR(sheets_.body(0).placement.position.y, 1 - 0.01, 0.002);
}

TEST_F(SolvedPlate, is_slowed_by_friction_proportional_to_its_weight) {
  motion().velocity = {2, 0, 0};
  touch_ground(0);
  constexpr int kTicks = 20;
  for (int i = 0; i < kTicks; ++i) solve();
  EXPECT_NEAR(motion().velocity.x, 2 - 0.6 * kFall * kTicks, 0.15 * 0.6 * kFall * kTicks);
  EXPECT_NEAR(motion().velocity.z, 0, 1e-6);
}

TEST_F(SolvedPlate, does_not_move_if_pinned_or_asleep) {
  sheets_.add(test::rectangle(1, 1, 1), {5, 5, 5});
  sheets_.body(1).pinned = true;
  motion().asleep = true;
  solve();
  EXPECT_EQ(motion().velocity, Vec3(0));
  EXPECT_EQ(sheets_.body(1).placement.position, Vec3(5, 5, 5));
}

}  // namespace
}  // namespace kerf
