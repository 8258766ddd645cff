#include <charconv>
#include <string>

#include "core/base/assert.h"
#include "core/laser/gcode.h"

namespace kerf {

namespace {

// Appends a word with the shortest decimals that read back as the same number; G-code has no exponents.
void append_gcode_word(std::string& text, char letter, double value) {
  char digits[400];
  const auto [end, fault] =
      std::to_chars(digits, digits + sizeof digits, value + 0.0, std::chars_format::fixed);
  KERF_ASSERT(fault == std::errc());
  if (!text.empty() && text.back() != '\n') text += ' ';
  text += letter;
  text.append(digits, end);
}

// Appends the axes in millimetres that differ from the previous point.
void append_gcode_axes(std::string& text, const Vec3& point, const Vec3* previous) {
  for (int i = 0; i < 3; ++i) {
    if (previous == nullptr || point[i] != (*previous)[i])
      append_gcode_word(text, static_cast<char>('X' + i), 1000 * point[i]);
  }
}

void append_gcode_stroke(std::string& text, const ProgramStroke& stroke) {
  text += "G0";
  append_gcode_axes(text, stroke.points.front(), nullptr);
  text += "\nM3";
  append_gcode_word(text, 'S', stroke.power_word);
  // A feed of no length switches the laser on in a dwell, too.
  text += "\nG1";
  append_gcode_word(text, 'F', 1000);
  text += '\n';
  double feed = 1000;
  if (stroke.points.size() == 1) text += "G4 P0\n";
  for (size_t k = 1; k < stroke.points.size(); ++k) {
    const double seconds = stroke.times[k] - stroke.times[k - 1];
    const double length = glm::length(stroke.points[k] - stroke.points[k - 1]);
    if (length > 0) {
      text += "G1";
      append_gcode_axes(text, stroke.points[k], &stroke.points[k - 1]);
      const double speed = 60'000 * length / seconds;
      if (speed != feed) append_gcode_word(text, 'F', speed);
      feed = speed;
    } else {
      text += "G4";
      append_gcode_word(text, 'P', seconds);
    }
    text += '\n';
  }
  text += "M5\n";
}

}  // namespace

std::string gcode_text(std::span<const ProgramStroke> strokes, const std::string& comment) {
  std::string text = "%\n(" + comment + ")\nG21 G90 G91.1 G94 G17\n";
  for (const ProgramStroke& stroke : strokes) append_gcode_stroke(text, stroke);
  return text + "M2\n%\n";
}

}  // namespace kerf
