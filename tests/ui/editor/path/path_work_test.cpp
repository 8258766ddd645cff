#include "ui/editor/path/path_tool.h"

#include <gtest/gtest.h>

#include "tests/support/made_meshes.h"
#include "ui/editor/path/path_feature.h"

namespace kerf {
namespace {

constexpr Vec3 kDownwards(0, -1, 0);

// Four points in two strokes.
PathWork two_strokes() {
  PathWork path;
  for (int i = 0; i < 4; ++i) {
    path.begin_edit();
    path.add({{i, 1, 0}, kDownwards}, 1, i == 2, 0.01, 2);
  }
  return path;
}

TEST(PathWork, points_follow_the_selected_one_or_begin_a_new_stroke) {
  PathWork path = two_strokes();
  ASSERT_EQ(path.strokes().size(), 2u);
  path.select(PathPoint{0, 0});
  path.begin_edit();
  path.add({{0.5, 1, 0}, kDownwards}, 1, false, 0.01, 2);
  EXPECT_EQ(path.selected(), (PathPoint{0, 1}));
  EXPECT_EQ(path.strokes()[0].keys.size(), 3u);
  EXPECT_EQ(path.target({0, 1}), Vec3(0.5, 0, 0));
  EXPECT_EQ(path.strokes()[0].times, (std::vector<double>{0, 0.25, 0.5}));
}

TEST(PathWork, a_moved_point_is_reached_at_the_path_speed) {
  PathWork path = two_strokes();
  path.begin_edit();
  path.set({0, 1}, {{3, 1, 0}, kDownwards}, 1);
  EXPECT_EQ(path.strokes()[0].times, (std::vector<double>{0, 1.5}));
  EXPECT_EQ(path.strokes()[1].times, (std::vector<double>{0, 0.5}));
}

TEST(PathWork, strokes_that_replace_a_single_point_keep_its_speed) {
  StrokePath hole;
  hole.keys = {{{0, 1, 0}, kDownwards}, {{1, 1, 0}, kDownwards}};
  hole.times = {0, 1};
  PathWork path;
  path.begin_edit();
  path.add({{0, 1, 0}, kDownwards}, 1, false, 0.01, 2);
  path.set_speed(0.5);
  path.begin_edit();
  path.add_strokes({hole}, World(), 1, 2);
  ASSERT_EQ(path.strokes().size(), 1u);
  EXPECT_EQ(path.speed(), 0.5);
  EXPECT_EQ(path.strokes()[0].times, (std::vector<double>{0, 2}));
  path.clear();
  path.add_strokes({hole}, World(), 1, 4);
  EXPECT_EQ(path.speed(), 4) << "of an empty path";
}

TEST(PathWork, strokes_added_to_a_path_with_the_times_of_its_file_have_its_mean_speed) {
  StrokePath stroke;
  stroke.keys = {{{0, 1, 0}, kDownwards}, {{1, 1, 0}, kDownwards}};
  stroke.times = {0, 4};
  PathWork path;
  path.load({stroke}, World());
  stroke.times = {0, 1};
  path.begin_edit();
  path.add_strokes({stroke}, World(), 1, 2);
  EXPECT_EQ(path.strokes()[1].times, (std::vector<double>{0, 4}));
  path.begin_edit();
  path.add({{5, 1, 0}, kDownwards}, 1, true, 0.01, 2);
  path.begin_edit();
  path.add({{6, 1, 0}, kDownwards}, 1, false, 0.01, 2);
  ASSERT_EQ(path.strokes().size(), 3u);
  EXPECT_EQ(path.strokes()[2].times, (std::vector<double>{0, 4}));
  EXPECT_TRUE(path.has_times_of_file());
}

TEST(PathWork, an_edit_after_undo_clears_the_redo_history) {
  PathWork path = two_strokes();
  path.undo();
  path.begin_edit();
  path.set_speed(5);
  EXPECT_FALSE(path.can_redo());
}

TEST(PathWork, deleting_the_last_point_deletes_the_stroke) {
  PathWork path = two_strokes();
  path.begin_edit();
  path.remove({1, 0});
  path.remove({1, 0});
  EXPECT_EQ(path.strokes().size(), 1u);
  EXPECT_EQ(path.selected(), (PathPoint{0, 1}));
  path.remove({0, 1});
  path.remove({0, 0});
  EXPECT_TRUE(path.empty());
  EXPECT_FALSE(path.selected().has_value());
}

TEST(PathWork, undo_and_redo_cover_all_edits) {
  PathWork path = two_strokes();
  path.begin_edit();
  path.clear();
  path.undo();
  EXPECT_EQ(path.points(), 4u);
  while (path.can_undo()) path.undo();
  EXPECT_TRUE(path.empty());
  for (int i = 0; i < 4; ++i) path.redo();
  EXPECT_EQ(path.points(), 4u);
  path.redo();
  EXPECT_TRUE(path.empty());
}

TEST(PathWork, a_run_is_undone_before_older_edits) {
  PathWork path = two_strokes();
  EXPECT_TRUE(path.is_newer_than(7));
  path.record_run(3);
  EXPECT_FALSE(path.is_newer_than(5));
  EXPECT_TRUE(path.is_newer_than(3));
  path.begin_edit();
  EXPECT_TRUE(path.is_newer_than(5));
}

TEST(PathWork, points_of_a_file_lie_on_the_surface_and_keep_their_times) {
  World world;
  world.add(make_body("sphere", test::build(test::sphere(24, 32, 1))));
  StrokePath stroke;
  stroke.keys = {{{0, 3, 0}, kDownwards}, {{5, 3, 0}, kDownwards}};
  stroke.times = {1, 11};
  PathWork path;
  path.begin_edit();
  path.load({stroke}, world);
  EXPECT_NEAR(path.target({0, 0}).y, 1, 0.01);
  EXPECT_NEAR(path.target({0, 1}).y, 0, 0.01);  // it misses: beside the middle of the world
  EXPECT_TRUE(path.has_times_of_file());
  EXPECT_EQ(path.speed(), 0.5);
  path.begin_edit();
  path.set({0, 1}, {{4, 3, 0}, kDownwards}, 3);
  EXPECT_EQ(path.strokes()[0].times, stroke.times);
  path.set_speed(2);
  EXPECT_EQ(path.strokes()[0].times, (std::vector<double>{0, 2}));
}

TEST(PlannedRun, of_the_thermal_model_has_the_radius_and_the_edges_of_kerf_cut) {
  StrokePath stroke;
  stroke.keys = {{{0, 1, 0}, kDownwards}, {{1, 1, 0}, kDownwards}};
  stroke.times = {0, 1};
  LaserControls laser;
  laser.model = Model::kThermal;
  laser.radius = 0.001;
  laser.power = 350;
  laser.resolution.edge_fraction = 0.125;
  const auto settings = [&](bool at_panel_resolution) {
    const PlannedRun planned = planned_run(std::span(&stroke, 1), laser, 4, at_panel_resolution);
    EXPECT_EQ(planned.message, "Path cut.");
    return std::get<BeginStroke>(planned.commands.front()).settings;
  };
  EXPECT_EQ(settings(false).laser.radius, 0.01);
  EXPECT_EQ(settings(false).laser.power, 350);
  EXPECT_EQ(settings(false).resolution.target_edge, 0.01);
  EXPECT_EQ(settings(false).resolution.rim, Rim::kFaces);
  EXPECT_EQ(settings(true).laser.radius, 0.01);
  EXPECT_EQ(settings(true).resolution.target_edge, 0.00125);
  stroke.radius = 0.002;
  EXPECT_EQ(settings(false).laser.radius, 0.002);
  EXPECT_EQ(settings(false).resolution.target_edge, 0.002);
}

TEST(PlannedRun, counts_strokes_that_last_no_time_in_the_thermal_model) {
  StrokePath burst;
  burst.keys = {{{0, 1, 0}, kDownwards}};
  burst.times = {0};
  LaserControls laser;
  EXPECT_EQ(planned_run(std::span(&burst, 1), laser, 4, false).message, "Path cut.");
  laser.model = Model::kThermal;
  EXPECT_EQ(planned_run(std::span(&burst, 1), laser, 4, false).message,
            "Path cut; 1 stroke lasts no time and emits no energy.");
  const std::vector<StrokePath> two{burst, burst};
  EXPECT_EQ(planned_run(two, laser, 4, false).message,
            "Path cut; 2 strokes last no time and emit no energy.");
}

}  // namespace
}  // namespace kerf
