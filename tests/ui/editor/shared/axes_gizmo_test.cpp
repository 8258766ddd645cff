#include "ui/editor/shared/gizmo.h"

#include <gtest/gtest.h>

namespace kerf {
namespace {

ViewState some_view() {
  ViewState view;
  view.layout = lay_out({1000, 700}, 16, 26, 26);
  view.camera.look({3, 2, 8}, {0, 0, 0});
  view.camera.finish();
  return view;
}

TEST(AxesGizmo, clicking_an_axis_end_views_from_there) {
  for (size_t i = 0; i < 6; ++i) {
    ViewState view = some_view();
    const AxisEnd end = axis_ends(view).at(i);
    const auto under = axis_end_under(view, end.at);
    ASSERT_TRUE(under && is_on_axes(view, end.at));
    EXPECT_EQ(name_of(*under), name_of(end));
    view.camera.turn_to(under->view.yaw, under->view.pitch);
    view.camera.finish();
    const Vec3 from = -view.seen().forward;
    EXPECT_NEAR(from[end.axis], end.positive ? 1 : -1, 1e-12) << name_of(end);
    EXPECT_STREQ(standard_view_of(view.camera)->name, end.view.name);
    EXPECT_EQ(axis_end_under(view, axis_ends(view).back().at)->axis, end.axis);
  }
}

TEST(AxesGizmo, lies_in_the_viewport_and_only_if_there_is_room) {
  ViewState view = some_view();
  for (const AxisEnd& end : axis_ends(view)) EXPECT_TRUE(view.layout.first.contains(end.at));
  EXPECT_FALSE(is_on_axes(view, view.layout.first.at + view.layout.first.size * 0.5));
  view.layout.first.size = Vec2(180);
  EXPECT_TRUE(axis_ends(view).empty());
  EXPECT_FALSE(is_on_axes(view, view.layout.first.at + Vec2(130, 50)));
}

}  // namespace
}  // namespace kerf
