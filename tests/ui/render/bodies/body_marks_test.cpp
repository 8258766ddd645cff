#include "ui/render/bodies/overlay_marks.h"

#include <gtest/gtest.h>

#include "core/document/scene.h"
#include "tests/support/checkout.h"
#include "tests/support/made_meshes.h"
#include "tests/ui/render/shadow_scenes.h"
#include "tests/ui/render/stage.h"

namespace kerf {
namespace {

constexpr int kMarksWidth = 160, kMarksHeight = 120;

// The columns in which two pictures differ.
Interval columns_that_differ(const Pixels& a, const Pixels& b) {
  Interval columns{kMarksWidth, -1};
  for (size_t i = 0; i < a.rgb.size(); ++i) {
    if (a.rgb[i] == b.rgb[i]) continue;
    const auto column = static_cast<double>(i / 3 % kMarksWidth);
    columns = {std::min(columns.low, column), std::max(columns.high, column)};
  }
  return columns;
}

// A chord across a sheet, from left to right.
TEST(BodyMarks, are_clipped_by_the_section_plane) {
  test::Stage stage(test::world_of_all({test::grid(10, 2)}));
  const CameraView view = look_at({0, 3, 2}, {0, 0, 0}, double{kMarksWidth} / kMarksHeight);
  auto marks = std::make_shared<BodyMarks>();
  marks->colliders.push_back({stage.world().ids()[0], {}, {{{-0.8, 0.01, 0}, {0.8, 0.01, 0}}}});
  const auto columns = [&](std::optional<double> plane) {
    ViewOptions options;
    options.antialias = false;
    if (plane) {
      options.show.section = true;
      options.section = SectionPlane{{*plane, 0, 0}, {1, 0, 0}};
    }
    const Pixels without = stage.draw(view, options, kMarksWidth, kMarksHeight);
    options.bodies = marks;
    return columns_that_differ(stage.draw(view, options, kMarksWidth, kMarksHeight), without);
  };
  const Interval whole = columns(std::nullopt);
  EXPECT_NEAR(whole.low + whole.high, kMarksWidth, 3);
  for (const double plane : {-0.3, 0.4}) {
    const Interval left = columns(plane);
    EXPECT_EQ(left.low, whole.low);
    EXPECT_NEAR(left.high, 0.5 * kMarksWidth + plane / 0.8 * 0.5 * (whole.high - whole.low), 3);
  }
}

// Which parts turn on joints is no reason to draw them as pieces that were cut off.
TEST(BodyMarks, a_car_keeps_its_paint_when_its_wheels_become_bodies) {
  auto scene = read_scene(test::checkout() / "assets/scenes/car.json");
  ASSERT_TRUE(scene.ok()) << scene.error().message;
  test::Stage stage(std::move(scene->world));
  const CameraView view = look_at({4, 1.5, 3}, {0, 0.6, 0}, double{kMarksWidth} / kMarksHeight);
  const ViewOptions options;
  const Pixels before = stage.draw(view, options, kMarksWidth, kMarksHeight);
  stage.pass(1);
  ASSERT_GT(stage.world().ids().size(), 1u);
  EXPECT_LT(test::difference(before, stage.draw(view, options, kMarksWidth, kMarksHeight)).mean, 0.4);
}

}  // namespace
}  // namespace kerf
