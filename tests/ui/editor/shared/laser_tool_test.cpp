#include <gtest/gtest.h>

#include <cmath>

#include "core/document/document.h"
#include "tests/support/made_meshes.h"
#include "ui/editor/shared/laser_controls.h"
#include "ui/render/passes/beam_effects.h"

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

TEST_F(LaserToolTest, a_drag_over_a_sphere_cuts_along_the_pointer) {
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

TEST_F(LaserToolTest, a_click_off_the_body_adds_no_step_unless_the_beam_edge_touches) {
  const auto click = [&](Vec2 at) {
    tool.press(document, view, at, controls, 7);
    tool.release(document);
    step();
  };
  click({-0.9, 0.9});
  EXPECT_EQ(document.history().size(), 0u);
  EXPECT_TRUE(document.journal().empty());
  double x = 0;
  while (first_hit(document.world(), view.ray(x, 0))) x += 0.001;
  click({x + 0.002, 0});
  EXPECT_EQ(document.history().size(), 1u);
  EXPECT_GT(document.history().totals().removed_faces, 0u);
}

TEST_F(LaserToolTest, a_stroke_has_begun_once_its_beam_meets_the_body_even_if_a_command_ends_it) {
  tool.press(document, view, {-0.9, 0}, controls, 7);
  EXPECT_FALSE(tool.has_begun());
  tool.move(document, view, {0, 0}, 2.0 / 700, 7.5);
  EXPECT_TRUE(tool.has_begun() && document.queue().in_stroke());
  ASSERT_TRUE(document.apply(RenamePiece{{document.world().ids().front(), 0}, "part"}).ok());
  EXPECT_TRUE(tool.has_begun() && !document.queue().in_stroke());
  const size_t commands = document.journal().size();
  EXPECT_FALSE(tool.release(document));
  EXPECT_EQ(document.journal().size(), commands);
}

TEST_F(LaserToolTest, a_drag_that_begins_off_the_body_keeps_its_first_pose) {
  tool.press(document, view, {-0.9, 0}, controls, 7);
  EXPECT_TRUE(document.journal().empty());
  tool.move(document, view, {0, 0}, 2.0 / 700, 7.5);
  tool.release(document);
  step();
  ASSERT_EQ(document.journal().size(), 3u);
  EXPECT_LT(std::get<BeginStroke>(document.journal().front()).pose.direction.x, -0.1);
  EXPECT_GT(document.history().totals().removed_faces, 0u);
}

TEST_F(LaserToolTest, a_drag_over_an_empty_world_has_a_beam_and_misses) {
  document = Document(World());
  for (const CameraView& from : {view, view.pulled(CameraView::kFarAway)}) {
    tool.press(document, from, {-0.2, 0}, controls, 7);
    tool.move(document, from, {0.2, 0}, 2.0 / 700, 7.5);
    const auto beam = tool.picture(document);
    ASSERT_TRUE(beam);
    EXPECT_TRUE(std::isfinite(glm::length(beam->from)) && std::isfinite(glm::length(beam->to)));
    EXPECT_TRUE(tool.release(document));
    EXPECT_TRUE(document.journal().empty());
  }
}

TEST_F(LaserToolTest, a_drag_that_misses_keeps_history_and_redo) {
  tool.press(document, view, {-0.2, 0}, controls, 7);
  EXPECT_FALSE(tool.release(document));
  step();
  ASSERT_TRUE(document.apply(Undo{}).ok());
  const size_t commands = document.journal().size();
  tool.press(document, view, {-0.9, 0.9}, controls, 8);
  for (const double x : {-0.5, 0.0, 0.5, 0.9}) tool.move(document, view, {x, 0.9}, 2.0 / 700, 8.5 + x);
  EXPECT_TRUE(tool.picture(document));
  EXPECT_TRUE(tool.release(document));
  EXPECT_EQ(document.journal().size(), commands);
  EXPECT_EQ(document.history().size(), 1u);  // can be redone
  EXPECT_FALSE(tool.cutting());
}

TEST_F(LaserToolTest, a_drag_that_crosses_a_body_between_two_events_cuts_it) {
  tool.press(document, view, {-0.9, 0}, controls, 7);
  tool.move(document, view, {0.9, 0}, 2.0 / 700, 7.5);
  EXPECT_FALSE(tool.release(document));
  step();
  EXPECT_EQ(document.history().size(), 1u);
  EXPECT_GT(document.history().totals().removed_faces, 0u);
}

TEST_F(LaserToolTest, a_drag_off_the_body_is_a_stroke_while_bodies_may_move_into_it) {
  tool.press(document, view, {-0.9, 0.9}, controls, 7);
  tool.move(document, view, {0.9, 0.9}, 2.0 / 700, 7.5);
  EXPECT_TRUE(document.journal().empty());
  tool.follow_time(document, true);
  EXPECT_EQ(document.journal().size(), 2u);
  tool.move(document, view, {-0.9, 0.9}, 2.0 / 700, 8);
  EXPECT_FALSE(tool.release(document));
  EXPECT_EQ(document.journal().size(), 4u);
}

TEST_F(LaserToolTest, a_fixed_beam_off_the_body_is_a_stroke_once_bodies_may_move_into_it) {
  tool.fire(document, {{0, 3, 5}, {0, 0, -1}}, 5, controls.settings(4), 7);
  tool.follow_time(document, false);
  EXPECT_TRUE(document.journal().empty());
  tool.follow_time(document, true);
  EXPECT_TRUE(tool.has_begun());
  ASSERT_EQ(document.journal().size(), 1u);
  EXPECT_FALSE(tool.release(document));
  tool.press(document, view, {-0.9, 0.9}, controls, 8);
  tool.follow_time(document, true);
  EXPECT_FALSE(tool.has_begun()) << "a click";
  EXPECT_TRUE(tool.release(document));
}

TEST_F(LaserToolTest, a_move_below_half_a_pixel_is_dropped) {
  tool.press(document, view, {0, 0}, controls, 7);
  const size_t commands = document.journal().size();
  tool.move(document, view, {0.0005, 0}, 2.0 / 700, 7.5);
  EXPECT_EQ(document.journal().size(), commands);
  tool.move(document, view, {0.05, 0}, 2.0 / 700, 7.5);
  EXPECT_EQ(document.journal().size(), commands + 1);
}

TEST_F(LaserToolTest, a_slit_follows_the_pointer_over_surfaces_at_all_distances) {
  // From the point of the sphere nearest to the eye almost to its outline.
  tool.press(document, view, {0, 0}, controls, 7);
  const Vec2 end(-0.3, 0.4);
  tool.move(document, view, end, 2.0 / 700, 7.5);
  tool.release(document);
  step();
  const double pixel = 2.0 / 700;
  for (const double share : {0.1, 0.3, 0.5, 0.7, 0.9, 0.95}) {
    const Vec2 p = end * share;
    const auto depth = first_hit(document.world(), view.ray(p.x, p.y));
    EXPECT_GT(depth.value_or(1e9), 5) << share;
    // The middle of the slit is where the pointer was, to two pixels.
    const Vec2 aside = glm::normalize(Vec2(end.y, -end.x * view.aspect)) / Vec2(view.aspect, 1);
    const auto width = [&](double side) {
      double w = 0;
      while (w < 0.3 &&
             first_hit(document.world(), view.ray(p.x + side * w * aside.x, p.y + side * w * aside.y))
                     .value_or(1e9) > 5)
        w += 0.25 * pixel;
      return w;
    };
    EXPECT_NEAR(width(1), width(-1), 4 * pixel) << share;
  }
}

TEST_F(LaserToolTest, a_stroke_in_an_orthographic_view_cuts_under_the_pointer) {
  const CameraView parallel = view.pulled(CameraView::kFarAway);
  const auto distance = [&](double x, double y) {
    return first_hit(document.world(), parallel.ray(x, y)).value_or(1e9) - parallel.focus;
  };
  tool.press(document, parallel, {-0.3, 0.1}, controls, 7);
  tool.move(document, parallel, {0.3, 0.1}, 2.0 / 700, 7.5);
  const auto beam = tool.picture(document);
  tool.release(document);
  step();
  for (const double x : {-0.3, -0.1, 0.1, 0.3}) EXPECT_GT(distance(x, 0.1), 0.5) << x;
  EXPECT_LT(distance(0, 0.3), 0);
  // The emitter is before the world, and not as far away as the eye.
  ASSERT_TRUE(beam);
  EXPECT_GT(beam->from.z, 1);
  EXPECT_LT(beam->from.z, 10);
}

TEST_F(LaserToolTest, the_beam_is_drawn_at_the_current_end_of_the_cut) {
  tool.press(document, view, {-0.3, 0}, controls, 7);
  step();
  tool.move(document, view, {0.3, 0}, 2.0 / 700, 7.5);
  const auto some = document.step(4);
  ASSERT_TRUE(some.ok() && some->last.has_value() && document.waiting() > 0);
  tool.reach(some->last->to);
  tool.find_impact(document);
  const auto beam = tool.picture(document);
  ASSERT_TRUE(beam && beam->strike);
  const double seen = view.project(*beam->strike).x;
  EXPECT_GT(seen, -0.3);
  EXPECT_LT(seen, 0.2);
  EXPECT_GT(first_hit(document.world(), view.ray(seen, 0)).value_or(1e9), 4.5);
  EXPECT_LT(first_hit(document.world(), view.ray(seen + 0.1, 0)).value_or(1e9), 4.5);
}

TEST_F(LaserToolTest, the_beam_ends_at_the_rim_of_the_hole_it_made) {
  tool.press(document, view, {0, 0}, controls, 7);
  step();
  tool.find_impact(document);
  const auto beam = tool.picture(document);
  ASSERT_TRUE(beam.has_value());
  ASSERT_TRUE(beam->strike.has_value());
  EXPECT_NEAR(beam->strike->z, 1, 0.1);
  tool.release(document);
  EXPECT_FALSE(tool.picture(document).has_value()) << "its last move is cut";
}

}  // namespace
}  // namespace kerf
