#include "ui/editor/path/path_feature.h"

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

}  // namespace
}  // namespace kerf
