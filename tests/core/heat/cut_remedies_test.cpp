#include "core/heat/lumped_cut.h"

#include <gtest/gtest.h>

#include "core/base/random.h"
#include "tests/support/laser_strips.h"

namespace kerf::test {
namespace {

LumpedCut balance(const LaserStrip& strip) { return {strip.substance, strip.power, 0, strip.kerf}; }

// Steel of 2 mm that the beam crosses half as fast again as it may, so that it does not get through.
class Remedies : public testing::Test {
 protected:
  Remedies() {
    strip_.thickness = 0.002;
    strip_.power = 2000;
    strip_.target_edge = 1;
    speed_ = 1.5 * cutting_speed(balance(strip_), strip_.thickness);
    all_ = remedies(balance(strip_), strip_.thickness, speed_);
  }

  static constexpr double kMargin = 1.15;  // between the balance and the sheet of faces
  LaserStrip strip_;
  double speed_ = 0;
  CutRemedies all_;
};

TEST_F(Remedies, each_one_alone_lets_the_beam_cut_through) {
  EXPECT_FALSE(is_in_two(cross(strip_, speed_)));
  EXPECT_LT(all_.speed, speed_);
  EXPECT_TRUE(is_in_two(cross(strip_, all_.speed / kMargin)));
  LaserStrip stronger = strip_;
  stronger.power = kMargin * all_.power;
  EXPECT_GT(all_.power, strip_.power);
  EXPECT_TRUE(is_in_two(cross(stronger, speed_)));
  LaserStrip narrower = strip_;
  narrower.kerf = all_.kerf / kMargin;
  ASSERT_GT(all_.kerf, 0);
  EXPECT_LT(all_.kerf, strip_.kerf);
  EXPECT_TRUE(is_in_two(cross(narrower, speed_)));
}

TEST_F(Remedies, do_not_exceed_what_is_needed) {
  EXPECT_FALSE(is_in_two(cross(strip_, kMargin * all_.speed)));
  LaserStrip stronger = strip_;
  stronger.power = all_.power / kMargin;
  EXPECT_FALSE(is_in_two(cross(stronger, speed_)));
}

TEST_F(Remedies, change_nothing_if_the_beam_already_cuts_through) {
  const double slow = 0.5 * speed_;
  const CutRemedies none = remedies(balance(strip_), strip_.thickness, slow);
  EXPECT_EQ(none.speed, slow);
  EXPECT_EQ(none.power, strip_.power);
  EXPECT_EQ(none.kerf, strip_.kerf);
}

TEST(BalanceRemedies, satisfy_the_balance) {
  Random random(20);
  for (int i = 0; i < 200; ++i) {
    SCOPED_TRACE("seed 20, row " + std::to_string(i));
    const double thickness = 1e-3 * random.uniform(0.3, 8);
    LumpedCut cut{Substance{}, random.uniform(100, 6000), 0, 1e-3 * random.uniform(0.1, 0.6)};
    const double speed = random.uniform(0.01, 1);
    if (cut_thickness(cut, speed) >= thickness) continue;
    const CutRemedies all = remedies(cut, thickness, speed);
    if (all.speed > 0) EXPECT_NEAR(cut_thickness(cut, all.speed), thickness, 1e-9 * thickness);
    LumpedCut stronger = cut, narrower = cut;
    stronger.power = all.power;
    EXPECT_NEAR(cut_thickness(stronger, speed), thickness, 1e-9 * thickness);
    if (all.kerf == 0) continue;
    narrower.kerf = all.kerf;
    EXPECT_NEAR(cut_thickness(narrower, speed), thickness, 1e-9 * thickness);
  }
}

}  // namespace
}  // namespace kerf::test
