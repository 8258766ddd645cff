#include "core/physics/sleep.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "core/base/ids.h"
#include "tests/core/physics/moving_sheets.h"
#include "tests/support/sheets.h"

namespace kerf {
namespace {

constexpr uint32_t kHalfASecond = kTicksPerSecond / 2;

// Sheets in a row that were slow for half a second.
class QuietRow : public testing::Test {
 protected:
  QuietRow() {
    for (int i = 0; i < 5; ++i) {
      sheets_.add(test::rectangle(1, 1, 1), {1.1 * i, 0, 0});
      sheets_.body(static_cast<uint32_t>(i)).motion.quiet = kHalfASecond;
    }
  }
  // The indices of those that are awake after a tick in which neighbours touch.
  std::string awake(bool touching) {
    std::vector<MovingBody>& bodies = sheets_.bodies();
    std::vector<TouchingPair> pairs;
    for (uint32_t i = 0; touching && i + 1 < bodies.size(); ++i)
      pairs.push_back({i, i + 1, {Contact{Vec3(0), {1, 0, 0}, 0, 0, {}}}, {}});
    woke_ = update_sleep(bodies, pairs, joints_, memory_, kTick);
    std::string text;
    for (uint32_t i = 0; i < bodies.size(); ++i) {
      if (!sheets_.body(i).motion.asleep) text += std::to_string(i);
    }
    return text;
  }

  test::MovingSheets sheets_;
  std::vector<BodyJoint> joints_;
  ContactMemory memory_;
  bool woke_ = false;
};

TEST_F(QuietRow, falls_asleep_and_stops) {
  sheets_.body(2).motion.velocity = {0.01, 0, 0};
  EXPECT_EQ(awake(true), "");
  EXPECT_EQ(sheets_.body(2).motion.velocity, Vec3(0));
}

TEST_F(QuietRow, stays_awake_within_two_bodies_of_a_restless_one) {
  sheets_.body(0).motion.quiet = kHalfASecond - 1;
  EXPECT_EQ(awake(false), "0");
  EXPECT_EQ(awake(true), "012");
}

TEST_F(QuietRow, wakes_along_joints) {
  for (uint32_t i = 0; i < 5; ++i) sheets_.body(i).motion.asleep = true;
  sheets_.body(1).motion.quiet = 0;
  const Joint joint{};
  joints_ = {{1, 4, &joint}};
  EXPECT_EQ(awake(false), "14");
  EXPECT_TRUE(woke_);
  EXPECT_EQ(awake(false), "14");
  EXPECT_FALSE(woke_) << "they were awake";
}

TEST_F(QuietRow, does_not_wake_through_a_pinned_body) {
  sheets_.body(0).motion.quiet = 0;
  sheets_.body(1).pinned = true;
  EXPECT_EQ(awake(true), "01") << "what is pinned neither sleeps nor wakes";
}

TEST_F(QuietRow, wakes_bodies_in_contact_before_they_fell_asleep) {
  for (uint32_t i = 0; i < 5; ++i) sheets_.body(i).motion.asleep = true;
  const auto ids = sheets_.world.ids();
  PairMemory touched{ids[2], ids[3], {}, {}, {}};
  touched.touching = true;
  memory_ = {touched};
  sheets_.body(2).motion.quiet = 0;
  EXPECT_EQ(awake(false), "23");
}

TEST_F(QuietRow, does_not_wake_bodies_that_were_only_near) {
  for (uint32_t i = 0; i < 5; ++i) sheets_.body(i).motion.asleep = true;
  const auto ids = sheets_.world.ids();
  memory_ = {PairMemory{ids[2], ids[3], {}, {}, {}}};
  sheets_.body(2).motion.quiet = 0;
  EXPECT_EQ(awake(false), "2");
}

// The first is restless, and wakes the second if it touches it before the tick is over. They are 3 mm apart,
// and quiet speeds close that gap within a tick only if both go towards each other.
TEST_F(QuietRow, wakes_bodies_that_come_near_within_the_tick) {
  const auto second_wakes = [&](double first, double second) {
    sheets_.body(0).motion.quiet = 0;
    sheets_.body(1).motion.quiet = kHalfASecond;
    sheets_.body(1).motion.asleep = false;
    sheets_.body(0).motion.velocity = {first, 0, 0};
    sheets_.body(1).motion.velocity = {second, 0, 0};
    const TouchingPair pair{0, 1, {Contact{Vec3(0), {-1, 0, 0}, 0.003, 0, {}}}, {}};
    update_sleep(sheets_.bodies(), {&pair, 1}, joints_, memory_, kTick);
    return !sheets_.body(1).motion.asleep;
  };
  EXPECT_TRUE(second_wakes(0.2, -0.2));
  EXPECT_FALSE(second_wakes(0.2, 0.2)) << "both go the same way";
  EXPECT_FALSE(second_wakes(-0.2, 0.2)) << "they part";
}

// Whether a tick at this speed and spin counts as quiet.
bool is_quiet(double speed, double spin, bool on_hinge = false, uint32_t crossed = 0, double size = 1) {
  test::MovingSheets sheets;
  for (int i = 0; i < 2; ++i) sheets.add(test::rectangle(size, size, 1), {0, 0.2 * i, 0});
  sheets.body(0).motion.velocity = {speed, 0, 0};
  sheets.body(0).motion.spin = {0, spin, 0};
  sheets.body(0).motion.quiet = 7;
  Joint hinge;
  hinge.kind = Joint::Kind::kHinge;
  const std::vector<BodyJoint> joints(on_hinge ? 1 : 0, BodyJoint{0, 1, &hinge});
  TouchingPair pair{0, 1, {Contact{}}, {}};
  pair.memory.crossed = crossed;
  count_quiet(sheets.bodies(), {&pair, 1}, joints);
  EXPECT_TRUE(sheets.body(0).motion.quiet == 8 || sheets.body(0).motion.quiet == 0);
  return sheets.body(0).motion.quiet == 8;
}

TEST(Quiet, means_speeds_below_both_limits) {
  EXPECT_TRUE(is_quiet(0.39, 0));
  EXPECT_FALSE(is_quiet(0.41, 0));
  EXPECT_TRUE(is_quiet(0, 0.99));
  EXPECT_FALSE(is_quiet(0, 1.01));
}

// The limit is that at which its corners move at 0.4 m/s.
TEST(Quiet, permits_a_small_body_to_spin_faster) {
  constexpr double kSize = 0.1;
  const double limit = 0.4 / (kSize * std::sqrt(0.5));
  EXPECT_TRUE(is_quiet(0, 0.99 * limit, false, 0, kSize));
  EXPECT_FALSE(is_quiet(0, 1.01 * limit, false, 0, kSize));
}

TEST(Quiet, is_stricter_on_a_hinge_and_impossible_while_pushed_out) {
  EXPECT_TRUE(is_quiet(0.039, 0, true));
  EXPECT_FALSE(is_quiet(0.041, 0, true));
  EXPECT_FALSE(is_quiet(0, 0, false, 3));
}

}  // namespace
}  // namespace kerf
