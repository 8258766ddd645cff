#include <gtest/gtest.h>

#include "core/base/random.h"
#include "core/laser/drawing.h"
#include "core/laser/gcode.h"

namespace kerf::test {
namespace {

std::vector<DrawnLine> random_lines(uint64_t seed) {
  Random random(seed);
  std::vector<DrawnLine> lines;
  for (int i = 0; i < 8; ++i) {
    DrawnLine& line = lines.emplace_back();
    line.closed = i % 2 == 0;
    for (int k = 0; k < 6; ++k) line.points.emplace_back(random.uniform(-1, 1), random.uniform(-0.5, 0.5));
  }
  return lines;
}

void expect_equal_lines(const std::vector<DrawnLine>& lines, const Drawing& drawing, Vec2 zero) {
  ASSERT_EQ(drawing.lines.size(), lines.size());
  for (size_t i = 0; i < lines.size(); ++i) {
    EXPECT_EQ(drawing.lines[i].closed, lines[i].closed);
    ASSERT_EQ(drawing.lines[i].points.size(), lines[i].points.size());
    for (size_t k = 0; k < lines[i].points.size(); ++k)
      EXPECT_LT(glm::length(drawing.lines[i].points[k] - zero - lines[i].points[k]), 1e-13);
  }
}

TEST(DrawingWriter, svg_and_dxf_are_read_back) {
  for (const uint64_t seed : {1, 2, 3}) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    const std::vector<DrawnLine> lines = random_lines(seed);
    const auto svg = read_svg(svg_text(lines), "a.svg", 1e-6), dxf = read_dxf(dxf_text(lines), "a.dxf", 1e-6);
    ASSERT_TRUE(svg && dxf);
    expect_equal_lines(lines, *svg, svg->middle);
    expect_equal_lines(lines, *dxf, Vec2(0));
  }
}

TEST(DrawingWriter, dxf_keeps_layers) {
  std::vector<DrawnLine> lines = random_lines(4);
  lines[1].layer = "HOLES";
  const auto dxf = read_dxf(dxf_text(lines), "a.dxf", 1e-6);
  ASSERT_TRUE(dxf);
  EXPECT_EQ(dxf->lines[0].layer, "0");
  EXPECT_EQ(dxf->lines[1].layer, "HOLES");
}

TEST(DrawingWriter, an_svg_stroke_has_the_layer_of_its_colour) {
  const auto drawing = read_svg(
      R"(<svg><g stroke="#F00"><path d="M0 0h9"/><path d="M0 1h9" style="stroke: Blue"/></g><path d="M0 2h9"/></svg>)",
      "a.svg", 1e-6);
  ASSERT_TRUE(drawing);
  ASSERT_EQ(drawing->lines.size(), 3u);
  EXPECT_EQ(drawing->lines[0].layer, "#ff0000");
  EXPECT_EQ(drawing->lines[1].layer, "blue");
  EXPECT_EQ(drawing->lines[2].layer, "");
}

TEST(DrawingWriter, a_colour_of_an_svg_stroke_in_numbers_has_six_digits) {
  const auto layer = [](const std::string& stroke) {
    const auto drawing = read_svg("<svg><path d='M0 0h9' stroke='" + stroke + "'/></svg>", "a.svg", 1e-6);
    return drawing && drawing->lines.size() == 1 ? drawing->lines[0].layer : "no line";
  };
  for (const char* red : {"#ff0000", "#F00", "rgb(255,0,0)", "RGB( 255 , 0 , 0 )", "rgb(100%, 0%, 0%)",
                          "rgb(300, -5, 0.4)", "rgb(255 0 0)"})
    EXPECT_EQ(layer(red), "#ff0000") << red;
  EXPECT_EQ(layer("rgb(10, 50%, 171)"), "#0a80ab");
  for (const char* other : {"red", "rgb(1,2)", "rgb(1,2,3,4)", "rgb(1,2,3", "rgb()", "hsl(0, 100%, 50%)"})
    EXPECT_EQ(layer(other), other);
}

TEST(PostProcessor, sets_the_words_and_decimals_of_a_program) {
  const ProgramStroke stroke{{{0.001, 0, 0}, {1.0 / 3, 0, 0}}, {0, 10}, 500, 0};
  PostProcessor grbl;
  grbl.percent = false;
  grbl.begin = {"G21 G90", "G17"};
  grbl.laser_on = "M4";
  grbl.full_power = 255;
  grbl.decimals = 2;
  EXPECT_EQ(
      gcode_text(std::array{stroke}, "x", grbl),
      "(x)\nG21 G90\nG17\nG0 X1.00 Y0.00 Z0.00\nM4 S127.50\nG1 F1000.00\nG1 X333.33 F1994.00\nM5\nM2\n");
  const auto program = read_gcode(gcode_text(std::array{stroke}, "x"), "a.nc", 1e-6);
  ASSERT_TRUE(program);
  EXPECT_EQ(program->strokes.at(0).points.back(), stroke.points.back());
}

}  // namespace
}  // namespace kerf::test
