#include <charconv>
#include <string>

#include "core/base/assert.h"
#include "core/laser/gcode.h"

namespace kerf {

namespace {

class GcodeWriter {
 public:
  explicit GcodeWriter(const PostProcessor& post) : post_(post) {}

  std::string write(std::span<const ProgramStroke> strokes, const std::string& comment) {
    if (post_.percent) text_ += "%\n";
    text_ += "(" + comment + ")\n";
    add_lines(post_.begin);
    for (const ProgramStroke& stroke : strokes) add_stroke(stroke);
    add_lines(post_.end);
    if (post_.percent) text_ += "%\n";
    return std::move(text_);
  }

 private:
  void add_lines(const std::vector<std::string>& lines) {
    for (const std::string& line : lines) text_ += line + "\n";
  }

  // Appends a word with decimals as the controller wants them, or the shortest that read back as the same
  // number; G-code has no exponents.
  void add_word(char letter, double value) {
    char digits[400];
    const auto [end, fault] =
        post_.decimals
            ? std::to_chars(digits, digits + sizeof digits, value, std::chars_format::fixed, *post_.decimals)
            : std::to_chars(digits, digits + sizeof digits, value + 0.0, std::chars_format::fixed);
    KERF_ASSERT(fault == std::errc());
    if (!text_.empty() && text_.back() != '\n') text_ += ' ';
    text_ += letter;
    text_.append(digits, end);
  }

  // Appends the axes in millimetres that differ from the previous point.
  void add_axes(const Vec3& point, const Vec3* previous) {
    for (int i = 0; i < 3; ++i) {
      if (previous == nullptr || point[i] != (*previous)[i])
        add_word(static_cast<char>('X' + i), 1000 * point[i]);
    }
  }

  void add_stroke(const ProgramStroke& stroke) {
    KERF_ASSERT(!stroke.points.empty() && stroke.times.size() == stroke.points.size());
    text_ += "G0";
    add_axes(stroke.points.front(), nullptr);
    text_ += "\n" + post_.laser_on;
    add_word('S', stroke.power_word / 1000 * post_.full_power);
    // A feed of no length switches the laser on in a dwell, too.
    double feed = 1000;
    text_ += "\nG1";
    add_word('F', feed);
    text_ += '\n';
    if (stroke.points.size() == 1) text_ += "G4 P0\n";
    for (size_t k = 1; k < stroke.points.size(); ++k) {
      const double seconds = stroke.times[k] - stroke.times[k - 1];
      const double length = glm::length(stroke.points[k] - stroke.points[k - 1]);
      if (length > 0) {
        text_ += "G1";
        add_axes(stroke.points[k], &stroke.points[k - 1]);
        const double speed = 60'000 * length / seconds;
        if (speed != feed) add_word('F', speed);
        feed = speed;
      } else {
        text_ += "G4";
        add_word('P', seconds);
      }
      text_ += '\n';
    }
    text_ += post_.laser_off + "\n";
  }

  const PostProcessor& post_;
  std::string text_;
};

}  // namespace

std::string gcode_text(std::span<const ProgramStroke> strokes, const std::string& comment,
                       const PostProcessor& post) {
  KERF_ASSERT(post.full_power > 0);
  return GcodeWriter(post).write(strokes, comment);
}

}  // namespace kerf
