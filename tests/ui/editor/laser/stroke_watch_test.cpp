#include "ui/editor/laser/material_rows.h"

#include <gtest/gtest.h>

#include "core/heat/lumped_cut.h"
#include "tests/support/made_meshes.h"
#include "ui/render/passes/beam_effects.h"

namespace kerf {
namespace {

// A sheet of steel of 2 mm that a beam crosses while somebody watches.
class StrokeWatchTest : public testing::Test {
 protected:
  StrokeWatchTest() {
    World world;
    sheet_.thickness = 0.002;
    world.body(world.add(make_body("sheet", test::build(test::grid(4, 0.02))))).sheet = sheet_;
    document_ = Document(std::move(world));
    settings_.model = Model::kThermal;
    settings_.laser.radius = 1e-4;
    settings_.laser.range = {0, 1};
    settings_.laser.power = 2000;
    settings_.resolution.target_edge = 5e-5;
  }

  double fastest() const {
    return cutting_speed({sheet_.substance, settings_.laser.power, 0, 2 * settings_.laser.radius},
                         sheet_.thickness);
  }

  void cross(double speed) {
    draw(0.002, speed);
    document_.apply(EndStroke{});
    while (document_.waiting() > 0) ASSERT_TRUE(document_.step(8).ok());
    watch_.follow(document_, std::nullopt);
  }

  // Draws a stroke at this place, which goes on.
  void draw(double x, double speed) {
    constexpr double kWay = 0.004;
    constexpr int kFrames = 60;
    const auto pose = [&](double share) { return Pose{{x, 0.1, kWay * (share - 0.5)}, {0, -1, 0}}; };
    document_.apply(BeginStroke{settings_, pose(0)});
    for (int i = 1; i <= kFrames; ++i) {
      const double share = static_cast<double>(i) / kFrames;
      document_.apply(MoveBeam{pose(share), share * kWay / speed});
      while (document_.waiting() > 0) ASSERT_TRUE(document_.step(8).ok());
      watch_.follow(document_, picture_of_beam(document_.world(), settings_, pose(share), 0.2));
      if (watch_.now() && watch_.now()->through) ++open_;
      if (watch_.now() && !watch_.now()->through) ++shut_;
      if (watch_.now()) last_speed_ = watch_.now()->speed;
    }
  }

  Sheet sheet_;
  CutSettings settings_;
  Document document_;
  StrokeWatch watch_;
  int open_ = 0, shut_ = 0;
  double last_speed_ = 0;
};

TEST_F(StrokeWatchTest, slow_stroke_cuts_through_everywhere) {
  cross(0.6 * fastest());
  EXPECT_GT(open_, 40);
  EXPECT_EQ(shut_, 0);
  EXPECT_NEAR(last_speed_, 0.6 * fastest(), 0.1 * fastest());
  ASSERT_NE(watch_.last(document_), nullptr);
  EXPECT_EQ(watch_.last(document_)->share, 1);
}

TEST_F(StrokeWatchTest, fast_stroke_does_not_cut_through_and_is_kept_until_undo) {
  cross(2.5 * fastest());
  EXPECT_EQ(open_, 0);
  EXPECT_GT(shut_, 40);
  const StrokeWatch::Crossing* last = watch_.last(document_);
  ASSERT_NE(last, nullptr);
  EXPECT_EQ(last->share, 0);
  EXPECT_NEAR(last->speed, 2.5 * fastest(), 0.1 * fastest());
  EXPECT_EQ(last->met.sheet, sheet_);
  EXPECT_NEAR(last->met.slant, 1, 1e-9);
  document_.apply(Undo{});
  EXPECT_EQ(watch_.last(document_), nullptr);
}

TEST_F(StrokeWatchTest, a_stroke_that_is_undone_leaves_the_result_of_the_one_before) {
  const double power = settings_.laser.power, speed = 2.5 * fastest();
  cross(speed);
  settings_.laser.power = 0.25 * power;
  draw(-0.002, speed);
  document_.apply(Undo{});
  watch_.follow(document_, std::nullopt);
  ASSERT_NE(watch_.last(document_), nullptr);
  EXPECT_EQ(watch_.last(document_)->settings.laser.power, power);
}

TEST_F(StrokeWatchTest, a_stroke_that_hits_nothing_leaves_the_result_of_the_one_before) {
  cross(2.5 * fastest());
  ASSERT_NE(watch_.last(document_), nullptr);
  const Pose beside{{1, 0.1, 0}, {0, -1, 0}};
  watch_.follow(document_, picture_of_beam(document_.world(), settings_, beside, 0.2));
  watch_.follow(document_, std::nullopt);
  EXPECT_NE(watch_.last(document_), nullptr);
}

TEST_F(StrokeWatchTest, a_stroke_without_a_pause_before_it_is_judged_by_its_own_settings) {
  const double power = settings_.laser.power, speed = 2.5 * fastest();
  draw(-0.002, speed);
  settings_.laser.power = 0.25 * power;
  cross(speed);
  ASSERT_NE(watch_.last(document_), nullptr);
  EXPECT_EQ(watch_.last(document_)->settings.laser.power, 0.25 * power);
}

}  // namespace
}  // namespace kerf
