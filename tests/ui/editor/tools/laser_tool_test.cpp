#include <gtest/gtest.h>

#include "core/document/document.h"
#include "tests/support/made_meshes.h"
#include "ui/editor/tools/laser_tool.h"
#include "ui/render/beam_strike.h"

namespace kerf {
namespace {

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
  tool.press(document, view, {-0.2, 0}, controls, 7);
  tool.move(document, view, {0.2, 0}, 2.0 / 700, 7.5);
  tool.release(document);
  step();
  for (const double x : {-0.2, 0.0, 0.2}) {
    // The near side is gone under the pointer: the ray goes on to the far side or through.
    EXPECT_GT(first_hit(document.world(), view.ray(x, 0)).value_or(1e9), 4.5) << x;
  }
  EXPECT_NEAR(*first_hit(document.world(), view.ray(0, 0.3)), 4, 0.2);
}

TEST_F(LaserToolTest, a_move_of_less_than_half_a_pixel_is_dropped) {
  tool.press(document, view, {0, 0}, controls, 7);
  const size_t commands = document.journal().size();
  tool.move(document, view, {0.0005, 0}, 2.0 / 700, 7.5);
  EXPECT_EQ(document.journal().size(), commands);
  tool.move(document, view, {0.05, 0}, 2.0 / 700, 7.5);
  EXPECT_EQ(document.journal().size(), commands + 1);
}

TEST_F(LaserToolTest, the_beam_strikes_the_rim_of_what_it_burnt) {
  tool.press(document, view, {0, 0}, controls, 7);
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
