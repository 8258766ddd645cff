#include "core/laser/gcode.h"

#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "core/base/deterministic_math.h"

namespace kerf::test {
namespace {

constexpr double kTolerance = 1e-6;

Program program_of_text(const std::string& text) {
  const auto program = read_gcode(text, "test.nc", kTolerance);
  EXPECT_TRUE(program.ok()) << (program ? "" : program.error().message);
  return program ? *program : Program();
}

std::string gcode_error(const std::string& text) {
  const auto program = read_gcode(text, "test.nc", kTolerance);
  return program ? "" : program.error().message;
}

double way_of_stroke(const ProgramStroke& stroke) {
  double way = 0;
  for (size_t i = 1; i < stroke.points.size(); ++i)
    way += glm::length(stroke.points[i] - stroke.points[i - 1]);
  return way;
}

TEST(Gcode, the_laser_is_on_in_feed_moves_while_s_is_positive) {
  const Program program = program_of_text(
      "%\nG21 G90\nM4 S0\nG0 X10\nG1 X20 F600\nS500\nX30\nS1000 X40\nG0 X50\nG1 "
      "X60\nM5\nX70\nM3\nX80\nM2\nX90\n");
  ASSERT_EQ(program.strokes.size(), 4u);
  const double begins[] = {20, 30, 50, 70}, powers[] = {500, 1000, 1000, 1000};
  for (size_t i = 0; i < 4; ++i) {
    EXPECT_NEAR(program.strokes[i].points.front().x, 1e-3 * begins[i], 1e-15);
    EXPECT_NEAR(program.strokes[i].points.back().x, 1e-3 * (begins[i] + 10), 1e-15);
    EXPECT_EQ(program.strokes[i].power_word, powers[i]);
  }
  // Six moves of 10 mm at 10 mm/s, and two rapid ones.
  EXPECT_NEAR(program.duration, 6 + 0.02 / kRapidSpeed, 1e-12);
}

TEST(Gcode, arcs_by_centre_radius_and_turns_satisfy_the_equation_of_the_circle) {
  const char* const arcs[] = {"G3 X0 Y10 I-10 J0", "G2 X0 Y10 I-10 J0",     "G3 X0 Y10 R10",
                              "G3 X0 Y10 R-10",    "G90.1 G3 X0 Y10 I0 J0", "G3 X10 Y0 I-10",
                              "G3 X0 Y10 I-10 P3"};
  const double quarters[] = {1, 3, 1, 3, 1, 4, 9};
  for (size_t i = 0; i < 7; ++i) {
    const Program program = program_of_text("G0 X10\nM3 S1 F1000\n" + std::string(arcs[i]));
    ASSERT_EQ(program.strokes.size(), 1u) << arcs[i];
    const ProgramStroke& stroke = program.strokes[0];
    const Vec3 centre =
        std::string(arcs[i]).find("R-10") == std::string::npos ? Vec3(0) : Vec3(0.01, 0.01, 0);
    for (const Vec3& point : stroke.points) EXPECT_NEAR(glm::length(point - centre), 0.01, 1e-14) << arcs[i];
    EXPECT_NEAR(way_of_stroke(stroke), quarters[i] * 0.5 * kPi * 0.01, 1e-5 * quarters[i]) << arcs[i];
    EXPECT_NEAR(stroke.times.back() - stroke.times.front(), quarters[i] * 0.5 * kPi * 0.01 / (1.0 / 60),
                1e-9);
  }
}

TEST(Gcode, helices_climb_evenly_in_the_plane_chosen) {
  const Program program = program_of_text("G18 G0 X10\nM3 S1 F1000\nG3 X10 Z0 Y4 I-10");
  ASSERT_EQ(program.strokes.size(), 1u);
  const ProgramStroke& stroke = program.strokes[0];
  for (size_t k = 0; k < stroke.points.size(); ++k) {
    const Vec3& point = stroke.points[k];
    EXPECT_NEAR(std::hypot(point.x, point.z), 0.01, 1e-14);
    const double share = static_cast<double>(k) / static_cast<double>(stroke.points.size() - 1);
    EXPECT_NEAR(point.y, 0.004 * share, 1e-15);
  }
  // G3 turns counter-clockwise as seen from +Y: from +X towards -Z.
  EXPECT_LT(stroke.points[1].z, 0);
}

TEST(Gcode, units_offsets_and_distances_have_their_meaning) {
  const Program program = program_of_text(
      "G20 G91 M3 S1\nG1 X1 F10\nX1\nG90 G92 X0\nX1\nG53 G1 X0\nG28 X1 (home)\nG21 G1 X0 F60\n");
  ASSERT_EQ(program.strokes.size(), 2u);
  const std::vector<Vec3>& points = program.strokes[0].points;
  const double inches[] = {0, 1, 2, 3, 0};
  ASSERT_EQ(points.size(), 5u);
  for (size_t i = 0; i < 5; ++i) EXPECT_NEAR(points[i].x, 0.0254 * inches[i], 1e-15);
  // G28 goes to the zero of the machine; the program's zero is 2 inches away.
  EXPECT_NEAR(program.strokes[1].points[0].x, 0, 1e-15);
  EXPECT_NEAR(program.strokes[1].points[1].x, 0.0508, 1e-15);
}

TEST(Gcode, g28_with_words_moves_these_axes_alone) {
  const Program program = program_of_text("G0 X50 Y20 Z5\nG28 G91 Z0\nG90 M3 G1 Y40 F600 S1000\n");
  ASSERT_EQ(program.strokes.size(), 1u);
  EXPECT_LT(glm::length(program.strokes[0].points.front() - Vec3(0.05, 0.02, 0)), 1e-15);
}

TEST(Gcode, a_full_circle_survives_rounding_of_its_ends) {
  for (const char* const turn : {"G2 X0.3 Y0 I0 J5", "G3 X0.3 Y0 I0 J-5"}) {
    const Program program =
        program_of_text(std::string("M3 S1 F600 G91 G0 X0.1\nX0.1\nX0.1\nG90\n") + turn + "\n");
    ASSERT_EQ(program.strokes.size(), 1u);
    EXPECT_NEAR(way_of_stroke(program.strokes[0]), 2 * kPi * 0.005, 1e-5);
  }
}

TEST(Gcode, the_feed_is_kept_where_its_mode_is_repeated) {
  EXPECT_EQ(program_of_text("M3 S1 G94 F600\nG1 X1\nG90 G94\nX2\n").strokes.size(), 1u);
}

TEST(Gcode, times_follow_feeds_inverse_times_and_dwells) {
  const Program program = program_of_text("M3 S1\nG93 G1 X10 F2\nX20 F4\nG94 F600 X30\nG4 P1.5\nX40\nM30\n");
  ASSERT_EQ(program.strokes.size(), 1u);
  const double times[] = {0, 30, 45, 46, 47.5, 48.5};
  ASSERT_EQ(program.strokes[0].times.size(), 6u);
  for (size_t i = 0; i < 6; ++i) EXPECT_NEAR(program.strokes[0].times[i], times[i], 1e-12);
  // With M4 the laser is off while nothing moves.
  EXPECT_EQ(program_of_text("M4 S1 F600\nG1 X1\nG4 P1\nX2\n").strokes.size(), 2u);
}

TEST(Gcode, comments_line_numbers_and_compact_words_are_read) {
  const Program program = program_of_text("%\nN10G21G90(plane (x)G17 ; end\nn20 m3s1 f6.\n");
  EXPECT_TRUE(program.strokes.empty());
}

TEST(Gcode, other_words_are_errors_with_line_and_column) {
  EXPECT_EQ(gcode_error("G21\nG1 X10 F100\nG41 D1\n"),
            "test.nc, line 3, column 1: G41 is not supported; remove the word or use another post-processor");
  EXPECT_NE(gcode_error("G0 X1\nG0 X1 A20\n").find("line 2, column 7: A20 is not supported"),
            std::string::npos);
  EXPECT_NE(gcode_error("M6 T1\n").find("M6 is not supported"), std::string::npos);
  EXPECT_NE(gcode_error("G1 F1 Xabc\n").find("line 1, column 7: the letter X must be followed by a number"),
            std::string::npos);
  EXPECT_NE(gcode_error("G1 X1\n").find("needs F"), std::string::npos);
  EXPECT_NE(gcode_error("G0 G1 X1\n").find("mutually exclusive"), std::string::npos);
  EXPECT_NE(gcode_error("G1 X10 F1\nG2 X5 Y5 I100 J100\n").find("line 2, column 1: the start and the end of the arc"),
            std::string::npos);
  EXPECT_NE(gcode_error("G2 X5 F1 R1\n").find("R is smaller"), std::string::npos);
  EXPECT_NE(gcode_error("(no end\nG1\n").find("line 1, column 1: the comment has no ')'"), std::string::npos);
  EXPECT_NE(gcode_error("#1=5\n").find("expected a word"), std::string::npos);
  EXPECT_NE(gcode_error("").find("no words"), std::string::npos);
}

TEST(Gcode, a_program_that_was_written_is_read_back) {
  const ProgramStroke square{
      {{0, 0, 0.01}, {0.04, 0, 0.01}, {0.04, 1.0 / 30, 0.01}, {0.04, 1.0 / 30, 0.01}, {0, 0, 0}},
      {3, 5, 5.25, 6, 7},
      800,
      0};
  const ProgramStroke point{{{1e-7, -12, 0}}, {0}, 1.0 / 3, 0};
  const Program back = program_of_text(gcode_text(std::vector{square, point}, "test"));
  ASSERT_EQ(back.strokes.size(), 2u);
  ASSERT_EQ(back.strokes[0].points.size(), square.points.size());
  for (size_t k = 0; k < square.points.size(); ++k) {
    EXPECT_LT(glm::length(back.strokes[0].points[k] - square.points[k]), 1e-15);
    EXPECT_NEAR(back.strokes[0].times[k] - back.strokes[0].times[0], square.times[k] - square.times[0],
                1e-12);
  }
  ASSERT_EQ(back.strokes[1].points.size(), 1u);
  EXPECT_LT(glm::length(back.strokes[1].points[0] - point.points[0]), 1e-14);
  EXPECT_EQ(back.strokes[1].power_word, 1.0 / 3);
}

RotaryAxes table_about_x() { return {{{'A', RotaryAxis::Turns::kTable, {1, 0, 0}, {0, 0, -0.01}}}, 0}; }

Result<Program> rotary_program(const std::string& text, const RotaryAxes& rotary) {
  return read_gcode(text, "test.nc", kTolerance, rotary);
}

TEST(Gcode, feeds_of_rotary_axes_are_those_of_linuxcnc) {
  RotaryAxes rotary = table_about_x();
  rotary.axes.push_back({'C', RotaryAxis::Turns::kTable, {0, 0, 1}, {}});
  // A alone: degrees per minute, in inches, too; with X: along X; A and C: the root of the sum of squares.
  const auto program = rotary_program(
      "M3 S1\nG1 A90 F360\nG20 X1 A0 F60\nG21 A30 C40 F600\nG93 A60 X0 F2\nG94 G0 A360\n", rotary);
  ASSERT_TRUE(program.ok()) << program.error().message;
  ASSERT_EQ(program->strokes.size(), 1u);
  const ProgramStroke& stroke = program->strokes[0];
  EXPECT_NEAR(stroke.times.back(), 15 + 1 + 5 + 30, 1e-9);
  EXPECT_NEAR(program->duration, stroke.times.back() + 300 / kRapidTurn, 1e-9);
  ASSERT_EQ(stroke.angles.size(), stroke.points.size());
  ASSERT_EQ(stroke.lines.size(), stroke.points.size());
  EXPECT_EQ(stroke.angles.back(), Vec3(60, 0, 40));
  EXPECT_EQ(stroke.lines.back(), 5u);
}

// The path of a point at rest in the beam is that of the table, the other way round.
TEST(Gcode, a_table_turns_the_beam_the_other_way_about_its_pivot) {
  const RotaryAxes rotary = table_about_x();
  const auto program = rotary_program("G0 Z5\nM3 S1\nG1 X10 A90 F60\n", rotary);
  ASSERT_TRUE(program.ok()) << program.error().message;
  const ProgramStroke& stroke = program->strokes[0];
  Pose before{};
  for (size_t k = 0; k < stroke.points.size(); ++k) {
    const Pose beam = program->rotary.beam({stroke.points[k], stroke.angles[k]});
    const double angle = radians_of(stroke.angles[k].x);
    // The table turns +Y to +Z, so the beam turns from above towards +Y.
    EXPECT_NEAR(glm::length(beam.origin - Vec3(stroke.points[k].x, 0.015 * std::sin(angle),
                                               0.015 * std::cos(angle) - 0.01)),
                0, 1e-15);
    EXPECT_NEAR(glm::length(beam.direction - Vec3(0, -std::sin(angle), -std::cos(angle))), 0, 1e-15);
    if (k > 0) {
      // The middle of the chord lies within the tolerance of the helix.
      const Vec3 middle = 0.5 * (before.origin + beam.origin) + Vec3(0, 0, 0.01);
      EXPECT_LE(0.015 - std::hypot(middle.y, middle.z), kTolerance);
    }
    before = beam;
  }
  // A whole turn restores the beam to the bit.
  EXPECT_EQ(rotary.beam({{0, 0, 0}, {720, 0, 0}}).origin, rotary.beam({}).origin);
}

TEST(Gcode, heads_turn_the_beam_about_a_pivot_that_moves_with_them) {
  RotaryAxes rotary{{{'C', RotaryAxis::Turns::kHead, {0, 0, 1}, {}},
                     {'B', RotaryAxis::Turns::kHead, {0, 1, 0}, {0, 0, 0.2}}},
                    0.01};
  const Pose tilted = rotary.beam({{1, 2, 3}, {0, 90, 0}});
  EXPECT_NEAR(glm::length(tilted.direction - Vec3(-1, 0, 0)), 0, 1e-15);
  EXPECT_NEAR(glm::length(tilted.origin - Vec3(1 - 0.19, 2, 3.2)), 0, 1e-14);
  // C carries B.
  const Pose turned = rotary.beam({{1, 2, 3}, {0, 90, 90}});
  EXPECT_NEAR(glm::length(turned.direction - Vec3(0, -1, 0)), 0, 1e-15);
  EXPECT_NEAR(glm::length(turned.origin - Vec3(1, 2 - 0.19, 3.2)), 0, 1e-14);
}

TEST(Gcode, rotary_axes_without_a_description_are_errors) {
  const auto program = rotary_program("G0 A10\nG1 F100 A20\nB10\n", table_about_x());
  ASSERT_FALSE(program.ok());
  EXPECT_NE(program.error().message.find("test.nc, line 3, column 1: B10 is not supported without"),
            std::string::npos);
}

}  // namespace
}  // namespace kerf::test
