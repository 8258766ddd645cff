#include "core/document/job_files.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>

#include "core/base/deterministic_math.h"
#include "core/document/drawing_layers.h"

namespace kerf::test {
namespace {

constexpr double kCurves = 1e-6;  // m

JobFile job_of(const std::string& text, JobFile::Kind kind) {
  const auto job = read_job_text(text, "test", kind, kCurves);
  EXPECT_TRUE(job.ok()) << (job ? "" : job.error().message);
  return job ? *job : JobFile();
}

// Two level strokes with powers, and one that climbs.
std::vector<StrokePath> level_strokes() {
  StrokePath a, b;
  a.power = 500;
  a.keys = {{{0.1, 1, 0.2}, {0, -1, 0}}, {{0.3, 1, 0.2}, {0, -1, 0}}, {{0.3, 1, -0.1}, {0, -1, 0}}};
  a.times = {2, 3.5, 3.75};
  b.power = 1500;
  b.keys = {{{-1.0 / 3, 0.5, 1e-6}, {0, -1, 0}}, {{0.7, 0.25, 0}, {0, -1, 0}}};
  b.times = {0, 1.0 / 7};
  return {a, b};
}

void expect_same_strokes(const std::vector<StrokePath>& a, const std::vector<StrokePath>& b) {
  ASSERT_EQ(a.size(), b.size());
  for (size_t i = 0; i < a.size(); ++i) {
    ASSERT_EQ(a[i].keys.size(), b[i].keys.size());
    for (size_t k = 0; k < a[i].keys.size(); ++k) {
      EXPECT_LT(glm::length(a[i].keys[k].origin - b[i].keys[k].origin), 1e-15);
      EXPECT_EQ(a[i].keys[k].direction, b[i].keys[k].direction);
      EXPECT_NEAR(a[i].times[k] - a[i].times[0], b[i].times[k] - b[i].times[0], 1e-12);
    }
    ASSERT_TRUE(a[i].power && b[i].power);
    EXPECT_NEAR(*a[i].power, *b[i].power, 1e-9);
  }
}

TEST(JobPlane, drawings_stand_upright_as_seen_along_the_beam) {
  const std::array<std::pair<const char*, Vec3>, 6> axes{{{"+x", {1, 0, 0}},
                                                          {"-x", {-1, 0, 0}},
                                                          {"+y", {0, 1, 0}},
                                                          {"-y", {0, -1, 0}},
                                                          {"+z", {0, 0, 1}},
                                                          {"-z", {0, 0, -1}}}};
  for (const auto& [name, beam] : axes) {
    const auto plane = plane_onto(name);
    ASSERT_TRUE(plane.ok());
    EXPECT_EQ(plane->beam, beam) << name;
    // The viewer looks along the beam: right, up and the way back to the viewer are right-handed.
    EXPECT_EQ(glm::cross(plane->right, plane->up), -beam) << name;
    if (beam.y == 0) EXPECT_EQ(plane->up, Vec3(0, 1, 0)) << name;
  }
  EXPECT_EQ(plane_onto("-y")->right, Vec3(1, 0, 0));
  EXPECT_EQ(plane_onto("-y")->up, Vec3(0, 0, -1));
  EXPECT_FALSE(plane_onto("y").ok());
}

TEST(JobPlane, points_are_scaled_then_turned_then_placed) {
  JobPlane plane = *plane_onto("-y");
  plane.at = {1, 2, 3};
  plane.turn = radians_of(90);
  plane.scale = 2;
  // Right becomes up: (1, 0) -> (0, 2), which is -z.
  EXPECT_LT(glm::length(plane.point({1, 0}, 0) - Vec3(1, 2, 1)), 1e-12);
  EXPECT_LT(glm::length(plane.point({0, 0}, 0.5) - Vec3(1, 3, 3)), 1e-12);
}

TEST(JobPlane, beams_from_an_eye_go_through_the_points_of_the_plane) {
  JobPlane plane = *plane_onto("-y");
  plane.eye = Vec3(0.1, 3, -0.2);
  plane.scale = 2;
  const std::vector<DrawnLine> lines{{{{0, 0}, {0.3, 0}, {0.3, 0.4}}, true, "HOLES"}};
  auto strokes = drawing_strokes(lines, {0, 0}, plane);
  ASSERT_EQ(strokes.size(), 1u);
  ASSERT_EQ(strokes[0].keys.size(), 4u);
  for (size_t k = 0; k < 4; ++k) {
    const Pose& key = strokes[0].keys[k];
    EXPECT_EQ(key.origin, *plane.eye);
    const Vec3 target = plane.point(lines[0].points[k % 3], 0) - key.origin;
    EXPECT_LT(glm::length(glm::cross(target, key.direction)), 1e-15);
    EXPECT_GT(glm::dot(target, key.direction), 0);
  }
  // The speed is that on the plane: 1.2 times the scale in all.
  EXPECT_NEAR(duration_of(strokes[0]), 2.4 / kDrawingSpeed, 1e-12);
  LayerTable table;
  table.layers["HOLES"].speed = 0.1;
  set_lasers(table, lines, strokes);
  EXPECT_NEAR(duration_of(strokes[0]), 24, 1e-12);
}

TEST(LayerTable, speeds_keep_times_ascending_at_points_that_nearly_coincide) {
  const std::vector<DrawnLine> lines{{{{0, 0}, {1, 0}}, false, "HOLES"}};
  LayerTable table;
  table.layers["HOLES"].speed = 1e6;
  std::vector<StrokePath> strokes(1);
  for (double time = 1.9; strokes[0].times.size() < 8; time = std::nextafter(time, 2.0))
    strokes[0].times.push_back(time);
  set_lasers(table, lines, strokes);
  const std::vector<double>& times = strokes[0].times;
  EXPECT_TRUE(std::ranges::adjacent_find(times, std::greater_equal()) == times.end());
}

TEST(JobFiles, a_path_is_the_same_after_a_program) {
  const std::vector<StrokePath> strokes = level_strokes();
  for (const std::optional<double> scale : {std::optional<double>(), std::optional<double>(2000.0)}) {
    const auto text = strokes_gcode(strokes, scale);
    ASSERT_TRUE(text.ok());
    const JobFile job = job_of(*text, JobFile::Kind::kProgram);
    expect_same_strokes(program_strokes(job.program, *plane_onto("-y"), scale.value_or(1500)), strokes);
  }
}

TEST(JobFiles, a_drawing_is_the_same_after_a_path_and_an_svg) {
  const JobFile job = job_of(
      "<svg width='60mm' height='40mm' viewBox='0 0 60 40'><circle cx='10' cy='20' r='5'/>"
      "<path d='M1 2L30 7 31 35'/></svg>",
      JobFile::Kind::kSvg);
  const auto strokes = drawing_strokes(job.drawing.lines, job.drawing.middle, *plane_onto("-y"));
  ASSERT_EQ(strokes.size(), 2u);
  EXPECT_LT(glm::length(strokes[1].keys[0].origin - Vec3(-0.029, 0, -0.018)), 1e-15);
  EXPECT_EQ(strokes[0].keys.front().origin, strokes[0].keys.back().origin);
  EXPECT_EQ(strokes[1].times.front(), 0);
  EXPECT_NEAR(duration_of(strokes[1]), way_of(strokes[1]) / kDrawingSpeed, 1e-12);
  const auto text = strokes_svg(strokes);
  ASSERT_TRUE(text.ok());
  const JobFile back = job_of(*text, JobFile::Kind::kSvg);
  const auto again = drawing_strokes(back.drawing.lines, back.drawing.middle, *plane_onto("-y"));
  ASSERT_EQ(again.size(), 2u);
  for (size_t i = 0; i < 2; ++i) {
    ASSERT_EQ(again[i].keys.size(), strokes[i].keys.size());
    for (size_t k = 0; k < strokes[i].keys.size(); ++k)
      EXPECT_LT(glm::length(again[i].keys[k].origin - strokes[i].keys[k].origin), 1e-15);
  }
}

TEST(JobFiles, flat_files_hold_only_a_beam_along_minus_y_and_level_lines) {
  std::vector<StrokePath> strokes = level_strokes();
  const auto svg = strokes_svg(strokes);
  ASSERT_FALSE(svg.ok());
  EXPECT_EQ(svg.error().message, "stroke 1: the path is not level; only flat paths can be converted");
  strokes[0].keys[1].direction = {1, 0, 0};
  const auto program = strokes_gcode(strokes, std::nullopt);
  ASSERT_FALSE(program.ok());
  EXPECT_EQ(program.error().message,
            "stroke 0: only a beam along -y can be converted; keep the path as JSON");
}

TEST(JobFiles, programs_hold_no_moves_that_are_faster_than_a_feed_can_state) {
  std::vector<StrokePath> strokes = level_strokes();
  strokes[1].times = {0, 1e-8};
  const auto program = strokes_gcode(strokes, std::nullopt);
  ASSERT_FALSE(program.ok());
  EXPECT_EQ(program.error().message,
            "stroke 1: a move is faster than 1e9 mm/min; give its keys times that are farther apart");
}

TEST(JobFiles, drawings_without_lines_are_bad_input) {
  const auto job = read_job_text("<svg><text>A</text></svg>", "a.svg", JobFile::Kind::kSvg, kCurves);
  ASSERT_FALSE(job.ok());
  EXPECT_EQ(job.error().message, "a.svg: the drawing has no lines; left out: 1 text");
}

TEST(JobFiles, endings_give_the_kind) {
  EXPECT_EQ(job_kind("a/b.SVG"), JobFile::Kind::kSvg);
  EXPECT_EQ(job_kind("b.dxf"), JobFile::Kind::kDxf);
  EXPECT_EQ(job_kind("b.nc"), JobFile::Kind::kProgram);
  EXPECT_EQ(job_kind("b.json"), JobFile::Kind::kPath);
  EXPECT_EQ(job_kind("b.obj"), std::nullopt);
}

}  // namespace
}  // namespace kerf::test
