#include <gtest/gtest.h>

#include "core/base/length_text.h"
#include "core/document/document.h"
#include "tests/support/made_meshes.h"
#include "ui/editor/frame_statistics.h"
#include "ui/editor/laser_tool.h"
#include "ui/editor/layout.h"
#include "ui/render/beam_strike.h"

namespace kerf {
namespace {

TEST(Layout, areas_tile_the_window) {
  for (const Vec2 window : {Vec2(800, 600), Vec2(1280, 800), Vec2(2560, 1440)}) {
    const Layout l = lay_out(window, 16, 26, 26);
    EXPECT_EQ(l.viewport.size.x + l.side.size.x, window.x);
    EXPECT_EQ(26 + l.viewport.size.y + l.status.size.y, window.y);
    EXPECT_GE(l.viewport.size.x, 320);
  }
}

TEST(Layout, a_narrow_window_gives_up_its_panels) {
  EXPECT_EQ(lay_out({500, 400}, 16, 26, 26).side.size.x, 0);
}

TEST(Layout, halves_tile_the_picture_and_stay_wide_enough_to_be_looked_at) {
  const Layout whole = lay_out({1280, 800}, 16, 26, 26);
  EXPECT_FALSE(whole.split());
  EXPECT_EQ(whole.first.size, whole.viewport.size);
  for (const double share : {0.0, 0.3, 0.5, 1.0}) {
    const Layout l = split_in_two(whole, share);
    EXPECT_TRUE(l.split());
    EXPECT_EQ(l.first.size.x + l.second.size.x, whole.viewport.size.x);
    EXPECT_EQ(l.second.at.x, l.first.at.x + l.first.size.x);
    EXPECT_GE(std::min(l.first.size.x, l.second.size.x), 120) << share;
  }
}

TEST(FrameStatistics, tells_nearest_ranks) {
  FrameStatistics frames;
  EXPECT_EQ(frames.percentile(0.5), 0);
  for (int i = 100; i >= 1; --i) frames.add(i);
  EXPECT_EQ(frames.percentile(0.5), 50);
  EXPECT_EQ(frames.percentile(0.99), 99);
  EXPECT_EQ(frames.longest(), 100);
  EXPECT_EQ(frames.frames(), 100u);
}

TEST(LengthText, chooses_the_unit) {
  EXPECT_EQ(length_text(0.01225), "12.2 mm");
  EXPECT_EQ(length_text(3), "3 m");
}

class LaserToolTest : public testing::Test {
 protected:
  LaserToolTest() {
    World world;
    world.add(make_body("sphere", test::build(test::sphere(24, 32, 1))));
    document = Document(std::move(world));
    controls.radius = 0.05;
  }
  void step() {
    while (document.waiting() > 0) ASSERT_TRUE(document.step(8).ok());
  }
  Document document;
  LaserControls controls;
  LaserTool tool;
  const CameraView view = look_at({0, 0, 5}, {0, 0, 0}, 1.5);
};

TEST_F(LaserToolTest, a_drag_over_a_sphere_cuts_where_the_pointer_goes) {
  tool.press(document, view, {-0.2, 0}, controls);
  tool.move(document, view, {0.2, 0}, 2.0 / 700);
  tool.release(document);
  step();
  for (const double x : {-0.2, 0.0, 0.2}) {
    // The near side is gone under the pointer: the ray goes on to the far side or through.
    EXPECT_GT(first_hit(document.world(), view.ray(x, 0)).value_or(1e9), 4.5) << x;
  }
  EXPECT_NEAR(*first_hit(document.world(), view.ray(0, 0.3)), 4, 0.2);
}

TEST_F(LaserToolTest, a_move_of_less_than_half_a_pixel_is_dropped) {
  tool.press(document, view, {0, 0}, controls);
  const size_t commands = document.journal().size();
  tool.move(document, view, {0.0005, 0}, 2.0 / 700);
  EXPECT_EQ(document.journal().size(), commands);
  tool.move(document, view, {0.05, 0}, 2.0 / 700);
  EXPECT_EQ(document.journal().size(), commands + 1);
}

TEST_F(LaserToolTest, the_beam_strikes_the_rim_of_what_it_burnt) {
  tool.press(document, view, {0, 0}, controls);
  step();
  tool.find_strike(document);
  const auto beam = tool.picture(document);
  ASSERT_TRUE(beam.has_value());
  ASSERT_TRUE(beam->strike.has_value());
  EXPECT_NEAR(beam->strike->z, 1, 0.1);
  tool.release(document);
  EXPECT_TRUE(tool.picture(document).has_value());  // the rim is still to be closed
  step();
  EXPECT_FALSE(tool.picture(document).has_value());
}

}  // namespace
}  // namespace kerf
