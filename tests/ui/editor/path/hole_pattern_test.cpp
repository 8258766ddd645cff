#include "ui/editor/path/hole_pattern.h"

#include <gtest/gtest.h>

#include "core/document/document.h"
#include "core/document/stroke_path.h"
#include "tests/support/made_meshes.h"

namespace kerf {
namespace {

const Pose kDown{{0.03, 0.2, -0.02}, {0, -1, 0}};

// What drilling the holes through a plate of 1 m makes of it.
struct Drilled {
  size_t pieces = 0;
  double removed = 0;  // m^2
};
Drilled drill(const HolePattern& pattern, double radius) {
  World world;
  world.add(make_body("plate", test::build(test::grid(30, 1))));
  Document document(std::move(world));
  const std::vector<StrokePath> strokes = hole_strokes(pattern, kDown, radius);
  EXPECT_TRUE(document.run_whole(path_commands(strokes, document.world().bounds().diagonal())).ok());
  return {document.world().live_pieces(), document.history().totals().removed_area};
}

TEST(HolePattern, every_hole_of_a_grid_cuts_a_disc_off_a_plate) {
  HolePattern grid;
  grid.rows = 2, grid.columns = 3, grid.spacing = 0.2, grid.hole_radius = 0.06;
  EXPECT_EQ(drill(grid, 0.01).pieces, 1 + 6u);
}

TEST(HolePattern, every_hole_of_a_circle_cuts_a_disc_off_a_plate) {
  HolePattern circle;
  circle.kind = HolePattern::Kind::kCircle;
  circle.count = 5, circle.circle_radius = 0.3, circle.hole_radius = 0.05;
  EXPECT_EQ(drill(circle, 0.01).pieces, 1 + 5u);
}

TEST(HolePattern, a_hole_no_wider_than_the_beam_is_a_single_burst) {
  HolePattern grid;
  grid.rows = 2, grid.columns = 2, grid.spacing = 0.3, grid.hole_radius = 0.02;
  const std::vector<StrokePath> strokes = hole_strokes(grid, kDown, 0.05);
  ASSERT_EQ(strokes.size(), 4u);
  for (const StrokePath& stroke : strokes) {
    EXPECT_EQ(stroke.keys.size(), 1u);
    EXPECT_EQ(stroke.radius, 0.02);
  }
  const Drilled drilled = drill(grid, 0.05);
  EXPECT_EQ(drilled.pieces, 1u);
  EXPECT_NEAR(drilled.removed, 4 * 3.14159 * 0.02 * 0.02, 0.002);
}

TEST(HolePattern, strokes_are_closed_and_centred_across_the_beam) {
  for (const Vec3& towards : {Vec3(0, -1, 0), Vec3(1, 0, 0), Vec3(0, 0, 2), Vec3(1, 2, -3)}) {
    HolePattern grid;
    const Pose beam{{1, 2, 3}, beam_direction(towards)};
    Vec3 sum(0);
    const std::vector<StrokePath> strokes = hole_strokes(grid, beam, 0.002);
    ASSERT_EQ(strokes.size(), 12u);
    for (const StrokePath& stroke : strokes) {
      EXPECT_EQ(stroke.keys.front().origin, stroke.keys.back().origin);
      EXPECT_EQ(stroke.keys.size(), stroke.times.size());
      for (size_t k = 0; k + 1 < stroke.keys.size(); ++k) {
        EXPECT_EQ(stroke.keys[k].direction, beam.direction);
        EXPECT_NEAR(glm::dot(stroke.keys[k].origin - beam.origin, beam.direction), 0, 1e-12);
        EXPECT_LT(stroke.times[k], stroke.times[k + 1]);
        sum += (stroke.keys[k].origin - beam.origin) / static_cast<double>(stroke.keys.size() - 1);
      }
    }
    EXPECT_LT(glm::length(sum), 1e-12);
  }
}

// Three holes across a plate of 1 m in y = 0; the outer ones lie beyond its edge.
TEST(HoleOutlines, are_circles_on_the_surface_or_at_the_depth_of_the_target) {
  World world;
  world.add(make_body("plate", test::build(test::grid(30, 1))));
  HolePattern grid;
  grid.rows = 1, grid.columns = 3, grid.spacing = 0.7, grid.hole_radius = 0.06;
  const std::vector<HoleOutline> outlines = hole_outlines(grid, kDown, 0.5, world, {});
  ASSERT_EQ(outlines.size(), hole_strokes(grid, kDown, 0.01).size());
  for (size_t i = 0; i < 3; ++i) {
    EXPECT_EQ(outlines[i].meets, i == 1 ? HoleOutline::Meets::kFully : HoleOutline::Meets::kNothing);
    Vec3 middle(0);
    for (const Vec3& p : outlines[i].points) middle += p / static_cast<double>(outlines[i].points.size());
    EXPECT_NEAR(middle.y, i == 1 ? 0 : 0.2 - 0.5, 1e-12);
    EXPECT_NEAR(glm::length(middle - Vec3(0.03, middle.y, -0.02)), i == 1 ? 0 : 0.7, 1e-12);
    for (const Vec3& p : outlines[i].points) {
      EXPECT_NEAR(glm::length(p - middle), 0.06, 1e-12);
      EXPECT_NEAR(p.y, middle.y, 1e-12);
    }
  }
}

TEST(HoleOutlines, of_the_exploded_view_meet_pieces_in_their_true_places) {
  World world;
  const BodyId plate = world.add(make_body("plate", test::build(test::grid(30, 1))));
  ViewOptions look;
  look.pieces[{plate, 0}].offset = {0, 0, 3};
  HolePattern single;
  single.rows = single.columns = 1, single.hole_radius = 0.06;
  EXPECT_EQ(hole_outlines(single, kDown, 0.5, world, look).front().meets, HoleOutline::Meets::kFully);
}

TEST(HoleOutlines, of_a_beam_that_begins_on_the_surface_lie_there) {
  World world;
  world.add(make_body("plate", test::build(test::grid(30, 1))));
  HolePattern single;
  single.rows = single.columns = 1, single.hole_radius = 0.06;
  const HoleOutline outline = hole_outlines(single, {{0.01, 0, 0.02}, {0, -1, 0}}, 0, world, {}).front();
  for (const Vec3& p : outline.points) EXPECT_NEAR(p.y, 0, 1e-12);
}

// The plate ends at x = 0.5; the first two centres lie on either side of this edge.
TEST(HoleOutlines, across_an_edge_meet_the_surface_in_part) {
  World world;
  world.add(make_body("plate", test::build(test::grid(30, 1))));
  HolePattern single;
  single.rows = single.columns = 1, single.hole_radius = 0.06;
  for (const double x : {0.47, 0.53}) {
    const Pose beam{{x, 0.2, 0.01}, {0, -1, 0}};
    const HoleOutline outline = hole_outlines(single, beam, 0.5, world, {}).front();
    EXPECT_EQ(outline.meets, HoleOutline::Meets::kInPart) << x;
    EXPECT_NEAR(outline.points.front().y, 0, 1e-12) << x;
  }
  const HoleOutline inside = hole_outlines(single, {{0.43, 0.2, 0.01}, {0, -1, 0}}, 0.5, world, {}).front();
  EXPECT_EQ(inside.meets, HoleOutline::Meets::kFully);
}

}  // namespace
}  // namespace kerf
