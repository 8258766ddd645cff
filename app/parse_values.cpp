#include "app/parse_values.h"

#include <charconv>
#include <cmath>

#include "core/document/text/fields.h"

namespace kerf {

bool parse_number(std::string_view text, double& value) {
  const auto [end, fault] = std::from_chars(text.data(), text.data() + text.size(), value);
  return fault == std::errc() && end == text.data() + text.size() && std::isfinite(value);
}

std::string check_number(const std::string& text, const NumberRange& range, bool whole) {
  double number = 0;
  const std::string kind = whole ? "a whole number " : "a number ";
  const std::string_view digits = std::string_view(text).substr(text.starts_with('+') ? 1 : 0);
  if (!parse_number(digits, number) || (whole && number != std::floor(number)))
    return "must be " + kind + limits_text(range);
  return range.contains(number) ? "" : out_of_limits(number, range);
}

std::string help_with_limits(const std::string& help, const NumberRange& range) {
  return help + "; " + limits_text(range);
}

Result<PixelSize> parse_size(const std::string& text) {
  constexpr double kLargest = 16384;
  const size_t cross = text.find('x');
  double width = 0, height = 0;
  const auto whole = [&](double n) { return n >= 1 && n <= kLargest && n == std::floor(n); };
  if (cross == std::string::npos || !parse_number(std::string_view(text).substr(0, cross), width) ||
      !parse_number(std::string_view(text).substr(cross + 1), height) || !whole(width) || !whole(height)) {
    return bad_input("--size: must be WxH in pixels, each from 1 to 16384, like 1280x720");
  }
  return PixelSize{static_cast<int>(width), static_cast<int>(height)};
}

Result<Vec3> parse_point(const std::string& option, const std::string& text) {
  const auto wrong = bad_input(option + ": must be three numbers, x,y,z");
  Vec3 point{0};
  std::string_view rest = text;
  for (int i = 0; i < 3; ++i) {
    const size_t comma = rest.find(',');
    if ((i < 2) == (comma == std::string_view::npos)) return wrong;
    if (!parse_number(rest.substr(0, comma), point[i])) return wrong;
    if (i < 2) rest.remove_prefix(comma + 1);
  }
  return point;
}

}  // namespace kerf
