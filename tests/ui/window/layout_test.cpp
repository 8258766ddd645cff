#include <gtest/gtest.h>

#include "ui/window/layout.h"

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

TEST(Layout, a_narrow_window_hides_its_panels) { EXPECT_EQ(lay_out({500, 400}, 16, 26, 26).side.size.x, 0); }

TEST(Layout, panels_leave_the_viewport_its_minimum_size) {
  for (const Vec2 window : {Vec2(640, 400), Vec2(1280, 720), Vec2(1920, 1080)}) {
    const Layout l = lay_out(window, 16, 26, 26, {.side = 21, .second_side = 21, .strip = 19});
    EXPECT_EQ(l.second_side.size.x + l.viewport.size.x + l.side.size.x, window.x);
    EXPECT_EQ(26 + l.viewport.size.y + l.strip.size.y + l.status.size.y, window.y);
    EXPECT_EQ(l.viewport.at.x, l.second_side.size.x);
    EXPECT_EQ(l.strip.at, l.viewport.at + Vec2(0, l.viewport.size.y));
    EXPECT_EQ(l.strip.size.x, l.viewport.size.x);
    EXPECT_GE(l.viewport.size.x, 320);
    EXPECT_GE(l.viewport.size.y, 160);
  }
}

TEST(Layout, split_views_tile_the_viewport_and_stay_wide_enough) {
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

}  // namespace
}  // namespace kerf
