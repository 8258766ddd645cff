#include "core/laser/drawing.h"

#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "core/base/deterministic_math.h"

namespace kerf::test {
namespace {

constexpr double kFlatness = 1e-6;  // m
constexpr double kMillimetre = 1e-3;

double area_of_line(const DrawnLine& line) {
  double area = 0;
  for (size_t i = 0; i < line.points.size(); ++i)
    area += 0.5 * cross2(line.points[i], line.points[(i + 1) % line.points.size()]);
  return area;
}

double length_of_line(const DrawnLine& line) {
  double length = 0;
  for (size_t i = 0; i + (line.closed ? 0 : 1) < line.points.size(); ++i)
    length += glm::length(line.points[(i + 1) % line.points.size()] - line.points[i]);
  return length;
}

// Reads the shapes on a page of 100 x 100 mm with units of millimetres. Its middle is at (50, -50) mm.
Drawing svg_of(const std::string& shapes) {
  const auto drawing =
      read_svg("<svg xmlns='http://www.w3.org/2000/svg' width='100mm' height='100mm' viewBox='0 0 100 100'>" +
                   shapes + "</svg>",
               "test.svg", kFlatness);
  EXPECT_TRUE(drawing.ok()) << (drawing ? "" : drawing.error().message);
  return drawing ? *drawing : Drawing();
}

std::string svg_error(const std::string& text) {
  const auto drawing = read_svg(text, "test.svg", kFlatness);
  return drawing ? "" : drawing.error().message;
}

Drawing dxf_of(const std::string& entities, const std::string& header = "") {
  const auto drawing = read_dxf(header + "0\nSECTION\n2\nENTITIES\n" + entities + "0\nENDSEC\n0\nEOF\n",
                                "test.dxf", kFlatness);
  EXPECT_TRUE(drawing.ok()) << (drawing ? "" : drawing.error().message);
  return drawing ? *drawing : Drawing();
}

void expect_same_points(const DrawnLine& a, const DrawnLine& b) {
  ASSERT_EQ(a.points.size(), b.points.size());
  EXPECT_EQ(a.closed, b.closed);
  for (size_t i = 0; i < a.points.size(); ++i) EXPECT_LT(glm::length(a.points[i] - b.points[i]), 1e-12);
}

// The distance of each point, and of the middle of each chord, from a circle.
void expect_on_circle(const DrawnLine& line, Vec2 centre, double radius) {
  for (size_t i = 0; i + 1 < line.points.size(); ++i) {
    EXPECT_NEAR(glm::length(line.points[i] - centre), radius, 1e-12);
    const Vec2 middle = 0.5 * (line.points[i] + line.points[i + 1]);
    EXPECT_NEAR(glm::length(middle - centre), radius, kFlatness);
  }
}

TEST(SvgDrawing, circles_and_ellipses_have_their_area_within_the_tolerance) {
  const Drawing drawing = svg_of("<circle cx='50' cy='50' r='15'/><ellipse cx='30' cy='40' rx='20' ry='5'/>");
  ASSERT_EQ(drawing.lines.size(), 2u);
  // Chords lie inside the curve, at most the tolerance away along its length.
  const double circle = kPi * 0.015 * 0.015, ellipse = kPi * 0.02 * 0.005;
  EXPECT_LE(std::abs(area_of_line(drawing.lines[0])), circle);
  EXPECT_NEAR(std::abs(area_of_line(drawing.lines[0])), circle, 2 * kPi * 0.015 * kFlatness);
  EXPECT_NEAR(std::abs(area_of_line(drawing.lines[1])), ellipse, 2 * kPi * 0.02 * kFlatness);
  EXPECT_TRUE(drawing.lines[0].closed);
  EXPECT_LT(glm::length(drawing.middle - Vec2(0.05, -0.05)), 1e-15);
}

TEST(SvgDrawing, a_shape_equals_the_path_that_the_standard_gives_for_it) {
  const Drawing drawing = svg_of(
      "<rect x='10' y='20' width='30' height='10' rx='3' ry='2'/>"
      "<path d='M13 20 H37 A3 2 0 0 1 40 22 V28 A3 2 0 0 1 37 30 H13 A3 2 0 0 1 10 28 V22 A3 2 0 0 1 13 20 "
      "Z'/>"
      "<polygon points='1,2 3,4 5,1'/><path d='m1 2 2 2 2 -3z'/>"
      "<line x1='1' y1='2' x2='7' y2='3'/><path d='M1,2L7,3'/>");
  ASSERT_EQ(drawing.lines.size(), 6u);
  for (size_t i = 0; i < 6; i += 2) expect_same_points(drawing.lines[i], drawing.lines[i + 1]);
  const double corners = (4 - kPi) * 3 * 2 * 1e-6;
  EXPECT_NEAR(std::abs(area_of_line(drawing.lines[0])), 300e-6 - corners, 4e-8);
}

TEST(SvgDrawing, relative_commands_equal_absolute_ones) {
  const Drawing drawing = svg_of(
      "<path d='M10 10 C20 10 20 20 30 20 S40 30 50 20 Q60 10 70 20 T90 20 A5 5 0 1 0 90 40 H80 V50 Z'/>"
      "<path d='m10 10c10 0 10 10 20 10s10 10 20 0q10-10 20 0t20 0a5 5 0 100 20h-10v10z'/>"
      "<path d='M10,10 C20,10,20,20,30,20 S40,30,50,20 Q60,10,70,20 T90,20 A5,5,0,1,0,90,40 L80,40 80,50 "
      "10,10'/>");
  ASSERT_EQ(drawing.lines.size(), 3u);
  for (const DrawnLine& line : drawing.lines) expect_same_points(line, drawing.lines[0]);
}

TEST(SvgDrawing, arcs_satisfy_the_equation_of_the_circle) {
  // Centre (30, 40), radius 25: from (5, 40) to (30, 15), the short and the long way.
  for (const char* const arc : {"M5 40 A25 25 0 0 1 30 15", "M5 40 A25 25 0 1 0 30 15"}) {
    const Drawing drawing = svg_of("<path d='" + std::string(arc) + "'/>");
    ASSERT_EQ(drawing.lines.size(), 1u);
    expect_on_circle(drawing.lines[0], Vec2(0.03, -0.04), 0.025);
    const double quarters = arc[11] == '1' || std::string(arc).find(" 1 0") != std::string::npos ? 3 : 1;
    EXPECT_NEAR(length_of_line(drawing.lines[0]), quarters * 0.5 * kPi * 0.025, 1e-5);
  }
}

TEST(SvgDrawing, radii_that_are_too_small_grow_to_a_half_circle) {
  const Drawing drawing = svg_of("<path d='M10 50 A1 1 0 0 1 30 50'/>");
  ASSERT_EQ(drawing.lines.size(), 1u);
  expect_on_circle(drawing.lines[0], Vec2(0.02, -0.05), 0.01);
}

TEST(SvgDrawing, bezier_curves_keep_the_tolerance) {
  const Drawing drawing = svg_of("<path d='M0 0 C30 0 60 30 60 90'/>");
  ASSERT_EQ(drawing.lines.size(), 1u);
  const auto at = [](double t) {
    const double s = 1 - t;
    return kMillimetre *
           (3 * s * s * t * Vec2(30, 0) + 3 * s * t * t * Vec2(60, -30) + t * t * t * Vec2(60, -90));
  };
  const std::vector<Vec2>& points = drawing.lines[0].points;
  const auto n = static_cast<double>(points.size() - 1);
  for (size_t i = 0; i + 1 < points.size(); ++i) {
    EXPECT_LT(glm::length(points[i] - at(static_cast<double>(i) / n)), 1e-12);
    const Vec2 middle = at((static_cast<double>(i) + 0.5) / n);
    EXPECT_LT(glm::length(0.5 * (points[i] + points[i + 1]) - middle), kFlatness);
  }
}

TEST(SvgDrawing, transforms_compose_as_matrices) {
  const Drawing drawing = svg_of(
      "<g transform='translate(10,20) rotate(30)'><g transform='scale(2 3) skewX(20)'>"
      "<line x1='1' y1='2' x2='3' y2='1' transform='rotate(90 5 5)'/></g></g>");
  ASSERT_EQ(drawing.lines.size(), 1u);
  const double turn = radians_of(30);
  const auto map = [&](double x, double y) {
    double px = 5 - (y - 5), py = 5 + (x - 5);  // rotate(90 5 5)
    px += std::tan(radians_of(20)) * py;        // skewX
    px *= 2, py *= 3;                           // scale
    return kMillimetre * Vec2(10 + std::cos(turn) * px - std::sin(turn) * py,
                              -(20 + std::sin(turn) * px + std::cos(turn) * py));
  };
  EXPECT_LT(glm::length(drawing.lines[0].points[0] - map(1, 2)), 1e-12);
  EXPECT_LT(glm::length(drawing.lines[0].points[1] - map(3, 1)), 1e-12);
}

TEST(SvgDrawing, units_are_those_of_css) {
  const auto drawing = read_svg(
      "<svg width='2in' height='96'><line x2='1in'/><line x2='96'/><line x2='72pt'/><line x2='25.4mm'/>"
      "<line x2='2.54cm'/><line x2='6pc'/><line x2='101.6Q'/><line x2='50%'/></svg>",
      "test.svg", kFlatness);
  ASSERT_TRUE(drawing.ok()) << drawing.error().message;
  ASSERT_EQ(drawing->lines.size(), 8u);
  for (const DrawnLine& line : drawing->lines) EXPECT_NEAR(line.points[1].x, 0.0254, 1e-15);
  EXPECT_LT(glm::length(drawing->middle - Vec2(0.0254, -0.0127)), 1e-15);
}

TEST(SvgDrawing, an_em_is_16_px_unless_a_font_size_is_given) {
  const auto drawing =
      read_svg("<svg><line x2='6em'/><line x2='6rem'/><line x2='12ex'/></svg>", "test.svg", kFlatness);
  ASSERT_TRUE(drawing.ok()) << drawing.error().message;
  for (const DrawnLine& line : drawing->lines) EXPECT_NEAR(line.points[1].x, 0.0254, 1e-15);
  const std::string why = "x2: font sizes are not read: give the length in px or mm";
  for (const std::string unit : {"em", "rem", "ex"}) {
    const std::string line = "<line x2='1" + unit + "'/>";
    EXPECT_EQ(svg_error("<svg font-size='8'>" + line + "</svg>"), "test.svg, line 1, column 31: " + why);
    EXPECT_NE(svg_error("<svg><g style='font-size: 8px'><g>" + line + "</g></g></svg>").find(why),
              std::string::npos);
  }
}

TEST(SvgDrawing, a_view_box_is_centred_in_a_page_of_another_shape) {
  const auto drawing =
      read_svg("<svg width='100mm' height='40mm' viewBox='-10 -10 20 20'><line x2='10'/></svg>", "test.svg",
               kFlatness);
  ASSERT_TRUE(drawing.ok());
  EXPECT_LT(glm::length(drawing->lines[0].points[0] - Vec2(0.05, -0.02)), 1e-15);
  EXPECT_LT(glm::length(drawing->lines[0].points[1] - Vec2(0.07, -0.02)), 1e-15);
}

TEST(SvgDrawing, uses_repeat_elements_and_elements_left_out_are_counted) {
  const Drawing drawing = svg_of(
      "<defs><path id='p' d='M0 0h1'/></defs><use href='#p' x='5' y='6'/><use href='#p' "
      "transform='scale(2)'/>"
      "<text>A</text><text>B</text><image/><rect width='1' height='1' clip-path='url(#c)'/>"
      "<path d='M0 0h9' style='display: none'/><g visibility='hidden'><path d='M0 0h9'/></g><use "
      "href='#q'/>");
  ASSERT_EQ(drawing.lines.size(), 3u);
  EXPECT_LT(glm::length(drawing.lines[0].points[1] - kMillimetre * Vec2(6, -6)), 1e-15);
  EXPECT_LT(glm::length(drawing.lines[1].points[1] - kMillimetre * Vec2(2, 0)), 1e-15);
  EXPECT_EQ(left_out_text(drawing),
            "left out: 1 clip-path, 1 image, 2 text, 1 use of an element that is not in the file");
}

TEST(SvgDrawing, a_use_sets_the_size_of_an_inner_svg) {
  const Drawing drawing = svg_of(
      "<defs><svg id='s' width='10' height='10' viewBox='0 0 1 1'><path d='M0 0h1'/></svg></defs>"
      "<use href='#s' x='5'/><use href='#s' width='20' height='30'/><use href='#s' height='4'/>");
  ASSERT_EQ(drawing.lines.size(), 3u);
  EXPECT_NEAR(length_of_line(drawing.lines[0]), 10 * kMillimetre, 1e-15);
  EXPECT_NEAR(length_of_line(drawing.lines[1]), 20 * kMillimetre, 1e-15);
  EXPECT_NEAR(length_of_line(drawing.lines[2]), 4 * kMillimetre, 1e-15);
}

TEST(SvgDrawing, a_switch_draws_its_first_child_that_needs_no_extension) {
  const Drawing drawing = svg_of(
      "<switch> <foreignObject requiredExtensions='urn:x'/><g><path d='M0 0h1'/><path d='M0 0h2'/></g>"
      "<path d='M0 0h9'/></switch><switch><image requiredExtensions='urn:x'/></switch><path d='M0 0h3'/>");
  ASSERT_EQ(drawing.lines.size(), 3u);
  for (const int i : {0, 1, 2}) {
    const Vec2 end = kMillimetre * Vec2(i + 1, 0);
    EXPECT_LT(glm::length(drawing.lines[static_cast<size_t>(i)].points[1] - end), 1e-15);
  }
  EXPECT_EQ(left_out_text(drawing), std::nullopt);
}

TEST(SvgDrawing, a_switch_draws_the_shapes_after_its_title_and_foreign_object) {
  const Drawing drawing = svg_of(
      "<switch><title>part</title><foreignObject width='9' height='9'/><path d='M0 0h1'/><path d='M0 0h9'/>"
      "</switch><switch><foreignObject/></switch>");
  ASSERT_EQ(drawing.lines.size(), 1u);
  EXPECT_LT(glm::length(drawing.lines[0].points[1] - kMillimetre * Vec2(1, 0)), 1e-15);
  EXPECT_EQ(left_out_text(drawing), "left out: 1 foreignObject");
}

TEST(SvgDrawing, a_line_that_returns_to_its_start_is_closed) {
  const Drawing drawing = svg_of(
      "<polyline points='0,0 10,0 10,10 0,10 0,0'/><path d='M10 5 A5 5 0 0 1 0 5 A5 5 0 0 1 10 5'/>"
      "<polyline points='0,0 10,0 0,0'/>");
  ASSERT_EQ(drawing.lines.size(), 3u);
  EXPECT_TRUE(drawing.lines[0].closed);
  EXPECT_EQ(drawing.lines[0].points.size(), 4u);
  EXPECT_TRUE(drawing.lines[1].closed);
  EXPECT_FALSE(drawing.lines[2].closed);
}

TEST(SvgDrawing, a_line_that_returns_to_its_start_within_rounding_is_closed) {
  // 0.1 + 0.2 - 0.2 is not 0.1.
  const Drawing drawing = svg_of("<path d='M.1 .1h.2v.2h-.2v-.2'/><path d='M.1 .1h.2v.2h-.2v-.2z'/>");
  ASSERT_EQ(drawing.lines.size(), 2u);
  for (const DrawnLine& line : drawing.lines) {
    EXPECT_TRUE(line.closed);
    EXPECT_EQ(line.points.size(), 4u);
  }
}

TEST(SvgDrawing, the_root_and_symbols_pass_their_properties_on) {
  const auto layers = [](const std::string& text) {
    const auto drawing = read_svg(text, "test.svg", kFlatness);
    EXPECT_TRUE(drawing.ok());
    std::string all;
    for (const DrawnLine& line : drawing->lines) all += line.layer + ' ';
    return all;
  };
  EXPECT_EQ(layers("<svg stroke='red'><path d='M0 0h9'/><path d='M0 0h9' stroke='inherit'/></svg>"),
            "red red ");
  EXPECT_EQ(layers("<svg><symbol id='s' stroke='blue'><path d='M0 0h9'/></symbol><use href='#s'/></svg>"),
            "blue ");
  EXPECT_EQ(layers("<svg visibility='hidden'><path d='M0 0h9'/></svg>"), "");
  EXPECT_EQ(layers("<a:svg xmlns:a='http://www.w3.org/2000/svg'><a:path d='M0 0h9' stroke='red'/></a:svg>"),
            "red ");
}

TEST(SvgDrawing, transforms_that_are_not_applied_are_reported) {
  EXPECT_EQ(left_out_text(svg_of("<path d='M0 0h9' transform='scale(2)' transform-origin='4 5'/>"
                                 "<g style='stroke: red; transform: rotate(90deg)'><path d='M0 0h9'/></g>"
                                 "<path d='M0 0h9' transform='scale(2)' style='stroke: red'/>")),
            "left out: 1 transform in style, 1 transform-origin");
  const auto turned = read_svg("<svg transform='rotate(90)'><path d='M0 0h9'/></svg>", "test.svg", kFlatness);
  ASSERT_TRUE(turned.ok());
  EXPECT_EQ(left_out_text(*turned), "left out: 1 transform of the page");
  const auto upright =
      read_svg("<svg style='transform: none'><path d='M0 0h9'/></svg>", "test.svg", kFlatness);
  ASSERT_TRUE(upright.ok());
  EXPECT_EQ(left_out_text(*upright), std::nullopt);
}

TEST(SvgDrawing, a_style_sheet_is_reported) {
  EXPECT_EQ(left_out_text(svg_of("<style>.a{display:none}</style><path class='a' d='M0 0h9'/>")),
            "left out: 1 style sheet");
  EXPECT_EQ(left_out_text(svg_of("<defs><style>.c{display:none}</style></defs><path class='c' d='M0 0h9'/>")),
            "left out: 1 style sheet");
}

TEST(SvgDrawing, shares_of_an_unknown_window_are_no_page) {
  const auto drawing =
      read_svg("<svg width='100%' height='100%'><line x1='96' x2='288'/></svg>", "test.svg", kFlatness);
  ASSERT_TRUE(drawing.ok());
  EXPECT_LT(glm::length(drawing->middle - Vec2(2 * 0.0254, 0)), 1e-15);
}

TEST(SvgDrawing, errors_name_line_and_column) {
  EXPECT_EQ(svg_error("<svg>\n  <path\n d='M0 0 L1 x'/>\n</svg>"),
            "test.svg, line 3, column 13: d: expected a number");
  EXPECT_EQ(svg_error("<svg><path d='L1 1'/></svg>"),
            "test.svg, line 1, column 15: d: a path must begin with M");
  EXPECT_EQ(svg_error("<svg>\n<g transform='turn(3)'/></svg>"),
            "test.svg, line 2, column 15: transform: this is no transform with as many numbers");
  EXPECT_EQ(
      svg_error("<svg><rect width='1vw' height='1'/></svg>"),
      "test.svg, line 1, column 20: width: the unit must be px, pt, pc, mm, cm, in, Q, em, rem, ex or %");
  EXPECT_NE(svg_error("<svg>\n<g>\n</svg>").find("test.svg, line 3"), std::string::npos);
  EXPECT_NE(svg_error("<html/>").find("not an SVG"), std::string::npos);
}

TEST(SvgDrawing, endless_repetition_and_huge_numbers_are_errors) {
  std::string nested;
  for (int i = 0; i < 40; ++i)
    nested += "<g id='g" + std::to_string(i + 1) + "'><use href='#g" + std::to_string(i) +
              "'/><use href='#g" + std::to_string(i) + "'/></g>";
  EXPECT_NE(
      svg_error("<svg><g id='g0'><path d='M0 0h1'/></g>" + nested + "</svg>").find("1 000 000 elements"),
      std::string::npos);
  EXPECT_NE(svg_error("<svg><use id='u' href='#u'/></svg>").find("nested too deeply"), std::string::npos);
  EXPECT_NE(svg_error("<svg><path d='M0 0H1e29'/></svg>").find("beyond 10 000 km"), std::string::npos);
}

TEST(DxfDrawing, bulges_are_arcs_whose_angle_has_their_tangent) {
  // A bulge is tan(angle / 4). The half circles of a slot, and an arc of a quarter turn.
  const Drawing slot = dxf_of(
      "0\nLWPOLYLINE\n90\n4\n70\n1\n10\n0\n20\n0\n10\n40\n20\n0\n42\n1\n10\n40\n20\n10\n10\n0\n20\n10\n42\n1"
      "\n");
  ASSERT_EQ(slot.lines.size(), 1u);
  EXPECT_NEAR(area_of_line(slot.lines[0]), 400e-6 + kPi * 25e-6, 2 * kPi * 0.005 * kFlatness);
  const double quarter = std::tan(kPi / 8);
  const Drawing arc =
      dxf_of("0\nLWPOLYLINE\n70\n0\n10\n10\n20\n0\n42\n" + std::to_string(quarter) + "\n10\n0\n20\n10\n");
  ASSERT_EQ(arc.lines.size(), 1u);
  for (const Vec2& point : arc.lines[0].points) EXPECT_NEAR(glm::length(point), 0.01, 1e-8);
}

TEST(DxfDrawing, lines_and_arcs_that_meet_become_one_closed_line) {
  const Drawing drawing = dxf_of(
      "0\nLINE\n8\nA\n10\n0\n20\n0\n11\n20\n21\n0\n0\nARC\n8\nA\n10\n20\n20\n5\n40\n5\n50\n270\n51\n90\n"
      "0\nLINE\n8\nA\n10\n0\n20\n10\n11\n20\n21\n10\n0\nLINE\n8\nA\n10\n0\n20\n10\n11\n0\n21\n0\n"
      "0\nLINE\n8\nB\n10\n0\n20\n0\n11\n-5\n21\n0\n");
  ASSERT_EQ(drawing.lines.size(), 2u);
  EXPECT_TRUE(drawing.lines[0].closed);
  EXPECT_FALSE(drawing.lines[1].closed);
  EXPECT_NEAR(std::abs(area_of_line(drawing.lines[0])), 200e-6 + 0.5 * kPi * 25e-6, kPi * 0.005 * kFlatness);
}

// A line that is shorter than the tolerance leads back to the end of another, and a polyline passes its
// start.
TEST(DxfDrawing, lines_that_meet_repeat_no_point) {
  const Drawing angle = dxf_of(
      "0\nLINE\n10\n0\n20\n0\n11\n10\n21\n0\n0\nLINE\n10\n10.0005\n20\n0\n11\n10\n21\n0\n"
      "0\nLINE\n10\n10\n20\n0\n11\n10\n21\n5\n");
  ASSERT_EQ(angle.lines.size(), 1u);
  ASSERT_EQ(angle.lines[0].points.size(), 3u);
  EXPECT_DOUBLE_EQ(length_of_line(angle.lines[0]), 0.015);
  const Drawing triangle = dxf_of(
      "0\nLWPOLYLINE\n70\n0\n10\n0\n20\n0\n10\n4\n20\n0\n10\n0\n20\n3\n10\n0\n20\n0\n10\n0.0005\n20\n0\n");
  ASSERT_EQ(triangle.lines.size(), 1u);
  EXPECT_TRUE(triangle.lines[0].closed);
  EXPECT_EQ(triangle.lines[0].points.size(), 3u);
}

TEST(DxfDrawing, units_are_those_of_the_header_else_millimetres) {
  const std::string line = "0\nLINE\n10\n0\n20\n0\n11\n2\n21\n0\n";
  EXPECT_NEAR(dxf_of(line).lines[0].points[1].x, 0.002, 1e-15);
  const auto header = [](int unit) {
    return "0\nSECTION\n2\nHEADER\n9\n$INSUNITS\n70\n" + std::to_string(unit) + "\n0\nENDSEC\n";
  };
  EXPECT_NEAR(dxf_of(line, header(1)).lines[0].points[1].x, 0.0508, 1e-15);
  EXPECT_NEAR(dxf_of(line, header(6)).lines[0].points[1].x, 2, 1e-15);
  EXPECT_NEAR(dxf_of(line, header(21)).lines[0].points[1].x, 2 * 1200.0 / 3937, 1e-15);
  EXPECT_NEAR(dxf_of(line, header(24)).lines[0].points[1].x, 2 * 5280 * 1200.0 / 3937, 1e-11);
}

TEST(DxfDrawing, units_of_astronomy_are_read_as_millimetres) {
  for (const std::string unit : {"18", "19", "20"}) {
    const Drawing drawing = dxf_of("0\nLINE\n10\n0\n20\n0\n11\n2\n21\n0\n",
                                   "0\nSECTION\n2\nHEADER\n9\n$INSUNITS\n70\n" + unit + "\n0\nENDSEC\n");
    ASSERT_EQ(drawing.lines.size(), 1u) << unit;
    EXPECT_NEAR(drawing.lines[0].points[1].x, 0.002, 1e-15) << unit;
  }
}

TEST(DxfDrawing, blocks_are_scaled_turned_and_repeated) {
  const std::string block =
      "0\nSECTION\n2\nBLOCKS\n0\nBLOCK\n2\nB\n10\n1\n20\n1\n0\nCIRCLE\n10\n1\n20\n1\n40\n2\n0\nENDBLK\n0\nEND"
      "SEC\n";
  const Drawing drawing =
      dxf_of("0\nINSERT\n2\nB\n10\n50\n20\n0\n41\n3\n42\n3\n50\n90\n70\n4\n71\n2\n44\n20\n45\n30\n", block);
  ASSERT_EQ(drawing.lines.size(), 8u);
  for (const DrawnLine& line : drawing.lines)
    EXPECT_NEAR(std::abs(area_of_line(line)), kPi * 36e-6, 2 * kPi * 0.006 * kFlatness);
  // The second column lies 20 mm along the turned x axis.
  EXPECT_NEAR(drawing.lines[1].points[0].y - drawing.lines[0].points[0].y, 0.02, 1e-12);
}

TEST(DxfDrawing, entities_of_a_block_on_layer_0_have_the_layer_of_the_insert) {
  const std::string file =
      "0\nSECTION\n2\nTABLES\n0\nLAYER\n2\n0\n62\n-"
      "7\n70\n0\n0\nENDSEC\n0\nSECTION\n2\nBLOCKS\n0\nBLOCK\n2\nB\n"
      "0\nLINE\n8\n0\n10\n0\n20\n0\n11\n1\n21\n1\n0\nENDBLK\n0\nENDSEC\n";
  const Drawing drawing = dxf_of("0\nINSERT\n2\nB\n8\nCUT\n", file);
  ASSERT_EQ(drawing.lines.size(), 1u);
  EXPECT_EQ(drawing.lines[0].layer, "CUT");
  EXPECT_EQ(dxf_of("0\nLINE\n8\n0\n10\n0\n20\n0\n11\n1\n21\n1\n", file).lines.size(), 0u);
}

TEST(DxfDrawing, rational_splines_are_exact_circles) {
  // A quarter of the circle of radius 10 as a quadratic with the weight cos 45 degrees in the middle.
  const Drawing drawing = dxf_of(
      "0\nSPLINE\n70\n4\n71\n2\n72\n6\n73\n3\n40\n0\n40\n0\n40\n0\n40\n1\n40\n1\n40\n1\n41\n1\n41\n0."
      "70710678118654757\n41\n1\n"
      "10\n10\n20\n0\n10\n10\n20\n10\n10\n0\n20\n10\n");
  ASSERT_EQ(drawing.lines.size(), 1u);
  expect_on_circle(drawing.lines[0], Vec2(0), 0.01);
}

TEST(DxfDrawing, lines_are_drawn_whatever_the_direction_of_their_thickness) {
  for (const char* const normal : {"210\n0\n220\n-1\n230\n0\n", "210\n0\n220\n0\n230\n-1\n"}) {
    const Drawing drawing = dxf_of(std::string("0\nLINE\n10\n1\n20\n2\n11\n3\n21\n4\n") + normal);
    EXPECT_EQ(left_out_text(drawing), std::nullopt);
    ASSERT_EQ(drawing.lines.size(), 1u);
    EXPECT_LT(glm::length(drawing.lines[0].points[0] - kMillimetre * Vec2(1, 2)), 1e-15);
    EXPECT_LT(glm::length(drawing.lines[0].points[1] - kMillimetre * Vec2(3, 4)), 1e-15);
  }
}

TEST(DxfDrawing, mirrored_planes_hidden_layers_and_other_entities_are_told_apart) {
  const std::string layers = "0\nSECTION\n2\nTABLES\n0\nLAYER\n2\nOFF\n62\n-7\n70\n0\n0\nENDSEC\n";
  const Drawing drawing = dxf_of(
      "0\nARC\n10\n10\n20\n0\n40\n5\n50\n0\n51\n90\n210\n0\n220\n0\n230\n-"
      "1\n0\nLINE\n8\nOFF\n10\n0\n20\n0\n11\n1\n21\n1\n"
      "0\nTEXT\n1\nA\n0\nHATCH\n0\nCIRCLE\n10\n0\n20\n0\n40\n1\n210\n1\n220\n0\n230\n0\n",
      layers);
  ASSERT_EQ(drawing.lines.size(), 1u);
  EXPECT_LT(glm::length(drawing.lines[0].points.front() - Vec2(-0.015, 0)), 1e-15);
  EXPECT_EQ(left_out_text(drawing),
            "left out: 1 HATCH, 1 TEXT, 1 element of a hidden layer, 1 tilted CIRCLE");
}

TEST(DxfDrawing, errors_name_the_line) {
  const auto error = [](const std::string& text) {
    const auto drawing = read_dxf(text, "test.dxf", kFlatness);
    return drawing ? "" : drawing.error().message;
  };
  EXPECT_EQ(error("0\nSECTION\n2\nENTITIES\n0\nCIRCLE\n40\nabc\n0\nENDSEC\n0\nEOF\n"),
            "test.dxf, line 8, column 1: CIRCLE: the group 40 must be a number");
  EXPECT_EQ(
      error("0\nSECTION\nx\n"),
      "test.dxf, line 3, column 1: expected a group code, a whole number; the file is no DXF or is damaged");
  EXPECT_NE(error("0\nSECTION\n2\nENTITIES\n").find("incomplete"), std::string::npos);
  EXPECT_NE(error(std::string("AutoCAD Binary DXF\r\n\x1a\0", 22)).find("binary"), std::string::npos);
}

TEST(DxfDrawing, blocks_that_contain_themselves_are_errors) {
  const auto drawing = read_dxf(
      "0\nSECTION\n2\nBLOCKS\n0\nBLOCK\n2\nB\n0\nINSERT\n2\nB\n0\nENDBLK\n0\nENDSEC\n0\nSECTION\n2\nENTITIES"
      "\n0\nINSERT\n2\nB\n"
      "0\nENDSEC\n0\nEOF\n",
      "test.dxf", kFlatness);
  ASSERT_FALSE(drawing.ok());
  EXPECT_EQ(drawing.error().message, "test.dxf, line 10, column 1: INSERT: blocks are nested too deeply");
}

}  // namespace
}  // namespace kerf::test
