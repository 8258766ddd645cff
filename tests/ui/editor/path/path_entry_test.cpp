#include "core/base/json.h"
#include "ui/editor/path/path_tool.h"

#include <gtest/gtest.h>

#include "tests/support/made_meshes.h"

namespace kerf {
namespace {

PathWork drawn_path() {
  PathWork path;
  path.begin_edit();
  path.add({{0, 1, 0}, {0, -1, 0}}, 0.75, false, 0.01, 2);
  path.begin_edit();
  path.add({{0.5, 1, 0}, {0, -1, 0}}, 0.5, false, 0.01, 2);
  path.begin_edit();
  path.add({{0, 1, 1}, glm::normalize(Vec3(0.3, -0.7, 0.2))}, 1.25, true, 0.02, 2);
  return path;
}

TEST(PathEntry, restores_the_path_exactly_with_targets_and_without_undo) {
  const PathWork path = drawn_path();
  const nlohmann::json entry = nlohmann::json::parse(path_entry(path).dump());
  const PathWork read = path_of_entry(entry, World());
  ASSERT_EQ(read.strokes().size(), 2u);
  for (size_t i = 0; i < 2; ++i) {
    EXPECT_EQ(read.strokes()[i].times, path.strokes()[i].times);
    EXPECT_EQ(read.strokes()[i].radius, path.strokes()[i].radius);
    for (size_t k = 0; k < path.strokes()[i].keys.size(); ++k) {
      EXPECT_EQ(read.pose({i, k}).direction, path.pose({i, k}).direction);
      EXPECT_EQ(read.target({i, k}), path.target({i, k}));
    }
  }
  EXPECT_EQ(read.speed(), 2);
  EXPECT_FALSE(read.has_times_of_file());
  EXPECT_FALSE(read.can_undo());
}

TEST(PathEntry, restores_a_path_that_cannot_be_run_yet) {
  PathWork path;
  path.begin_edit();
  path.add({{0, 1, 0}, {0, -1, 0}}, 0.5, false, 0.01, 2);
  path.begin_edit();
  path.add({{0, -1, 0}, {0, 1, 0}}, 0.5, false, 0.01, 2);
  path.begin_edit();
  path.add({{0, 1, 1}, {0, -1, 0}}, 0.5, true, 0, 2);
  ASSERT_TRUE(rejection_reason(path.strokes()).has_value());
  const PathWork read = path_of_entry(nlohmann::json::parse(path_entry(path).dump()), World());
  ASSERT_EQ(read.strokes().size(), 2u);
  EXPECT_EQ(read.pose({0, 1}).direction, Vec3(0, 1, 0));
  EXPECT_EQ(read.strokes()[1].radius, 0.0);
}

TEST(PathEntry, restores_the_speed_of_a_path_whose_beam_begins_on_the_surface) {
  World world;
  world.add(make_body("plate", test::build(test::grid(30, 1))));
  StrokePath stroke;
  stroke.keys = {{{0.01, 0, 0.02}, {0, -1, 0}}, {{0.21, 0, 0.02}, {0, -1, 0}}};
  stroke.times = {0, 1};
  PathWork path;
  path.load({stroke}, world);
  EXPECT_EQ(path.distance({0, 0}), 0);
  path.begin_edit();
  path.set_speed(0.1);
  const PathWork read = path_of_entry(nlohmann::json::parse(path_entry(path).dump()), world);
  EXPECT_FALSE(read.has_times_of_file());
  EXPECT_EQ(read.speed(), 0.1);
}

TEST(PathEntry, is_null_for_an_empty_path_and_reads_as_empty_if_invalid) {
  EXPECT_TRUE(path_entry(PathWork()).is_null());
  EXPECT_TRUE(path_of_entry(nullptr, World()).empty());
  EXPECT_TRUE(path_of_entry({{"strokes", "none"}}, World()).empty());
  nlohmann::json damaged = path_entry(drawn_path());
  damaged["strokes"][0]["keys"][0]["direction"] = {0, 0, 0};
  EXPECT_TRUE(path_of_entry(damaged, World()).empty());
}

TEST(PathEntry, points_without_valid_distances_aim_at_the_world) {
  nlohmann::json damaged = path_entry(drawn_path());
  damaged["distances"][1] = {-1};
  const PathWork read = path_of_entry(damaged, World());
  EXPECT_EQ(read.points(), 3u);
  EXPECT_GT(read.distance({1, 0}), 0);
}

}  // namespace
}  // namespace kerf
