#include "ui/screen/live_picture.h"

#include <gtest/gtest.h>

#include "tests/ui/render/stage.h"
#include "ui/gl/buffers.h"

namespace kerf {
namespace {

constexpr int kWidth = 120, kHeight = 80;

// A ball beside a ring with a warm rim, of which the picture is drawn again in every frame.
class TracedShadowsTest : public testing::Test {
 protected:
  TracedShadowsTest() { options_.show.shadow_reference = true; }
  void frame(bool fresh, bool still) {
    const Target target{picture_.name(), 0, 0, kWidth, kHeight};
    stage_.renderer().draw(stage_.world(), view_, options_, std::nullopt, target);
    traced_.work(stage_.world(), options_, stage_.renderer(), view_, target, fresh, still, statistics_);
  }
  test::Stage stage_ = test::ball_and_ring();
  gl::Framebuffer picture_{{kWidth, kHeight, 1, false}};
  CameraView view_ = test::view_of_ball_and_ring(static_cast<double>(kWidth) / kHeight);
  ViewOptions options_;
  TracedShadows traced_;
  ShadowStatistics statistics_;
};

TEST_F(TracedShadowsTest, take_several_frames_and_report_only_complete_results) {
  frame(true, false);
  EXPECT_EQ(statistics_.traced, 0);
  for (double before = 0; statistics_.traced < 1; before = statistics_.traced) {
    EXPECT_TRUE(traced_.busy());
    EXPECT_FALSE(statistics_.wrong.has_value());
    frame(false, true);
    ASSERT_GT(statistics_.traced, before);
  }
  ASSERT_TRUE(statistics_.wrong.has_value());
  EXPECT_LT(*statistics_.wrong, static_cast<size_t>(kWidth * kHeight / 100));
  EXPECT_FALSE(traced_.busy());
}

TEST_F(TracedShadowsTest, wait_while_the_viewport_changes_and_restart_for_a_new_frame) {
  frame(true, false);
  frame(false, true);
  const double before = statistics_.traced;
  ASSERT_GT(before, 0);
  frame(false, false);
  EXPECT_EQ(statistics_.traced, before);
  frame(true, false);
  EXPECT_EQ(statistics_.traced, 0);
  options_.show.shadow_reference = false;
  frame(false, true);
  EXPECT_EQ(statistics_.traced, 0);
  EXPECT_FALSE(statistics_.wrong.has_value());
}

TEST_F(TracedShadowsTest, are_complete_and_right_without_a_light) {
  options_.lights.clear();
  frame(true, true);
  EXPECT_FALSE(traced_.busy());
  EXPECT_EQ(statistics_.wrong, 0u);
}

}  // namespace
}  // namespace kerf
