#include <charconv>
#include <string>

#include "core/base/assert.h"
#include "core/laser/drawing.h"

namespace kerf {

namespace {

constexpr double kMillimetres = 1000;  // per metre

// Appends the shortest decimals that read back as the same number, without an exponent.
void append_decimals(std::string& text, double number) {
  char digits[400];
  const auto [end, fault] =
      std::to_chars(digits, digits + sizeof digits, number + 0.0, std::chars_format::fixed);
  KERF_ASSERT(fault == std::errc());
  text.append(digits, end);
}

// Appends a group of DXF: its code and its value, a line each.
void append_group(std::string& text, int code, std::string_view value) {
  text += std::to_string(code) + "\n";
  text += value;
  text += '\n';
}

void append_point(std::string& text, Vec2 point) {
  for (int k = 0; k < 2; ++k) {
    std::string number;
    append_decimals(number, kMillimetres * point[k]);
    append_group(text, 10 * (k + 1), number);
  }
}

// The layer of a line; "0", which every drawing has, if it has none.
std::string_view dxf_layer(const DrawnLine& line) {
  return line.layer.empty() ? "0" : std::string_view(line.layer);
}

}  // namespace

std::string svg_text(std::span<const DrawnLine> lines) {
  Vec2 half{0.5};
  for (const DrawnLine& line : lines) {
    for (const Vec2& point : line.points) half = glm::max(half, kMillimetres * glm::abs(point));
  }
  std::string text = R"(<svg xmlns="http://www.w3.org/2000/svg" width=")";
  append_decimals(text, 2 * half.x);
  text += "mm\" height=\"";
  append_decimals(text, 2 * half.y);
  text += "mm\" viewBox=\"";
  for (const double x : {-half.x, -half.y, 2 * half.x}) {
    append_decimals(text, x);
    text += ' ';
  }
  append_decimals(text, 2 * half.y);
  text += "\" fill=\"none\" stroke=\"black\" stroke-width=\"0.1\">\n";
  for (const DrawnLine& line : lines) {
    text += "  <path d=\"";
    for (size_t i = 0; i < line.points.size(); ++i) {
      text += i == 0 ? "M" : " L";
      append_decimals(text, kMillimetres * line.points[i].x);
      text += ' ';
      append_decimals(text, -kMillimetres * line.points[i].y + 0.0);
    }
    text += line.closed ? " Z\"/>\n" : "\"/>\n";
  }
  return text + "</svg>\n";
}

std::string dxf_text(std::span<const DrawnLine> lines) {
  std::string text;
  append_group(text, 0, "SECTION");
  append_group(text, 2, "HEADER");
  append_group(text, 9, "$ACADVER");
  append_group(text, 1, "AC1009");
  append_group(text, 9, "$INSUNITS");
  append_group(text, 70, "4");  // millimetres
  append_group(text, 0, "ENDSEC");
  append_group(text, 0, "SECTION");
  append_group(text, 2, "ENTITIES");
  for (const DrawnLine& line : lines) {
    append_group(text, 0, "POLYLINE");
    append_group(text, 8, dxf_layer(line));
    append_group(text, 66, "1");  // vertices follow
    append_group(text, 70, line.closed ? "1" : "0");
    for (const Vec2& point : line.points) {
      append_group(text, 0, "VERTEX");
      append_group(text, 8, dxf_layer(line));
      append_point(text, point);
    }
    append_group(text, 0, "SEQEND");
  }
  append_group(text, 0, "ENDSEC");
  append_group(text, 0, "EOF");
  return text;
}

}  // namespace kerf
