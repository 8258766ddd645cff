#include "app/arguments.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <filesystem>

#include "core/document/text/fields.h"

namespace kerf {

bool parse_number(std::string_view text, double& value) {
  const auto [end, fault] = std::from_chars(text.data(), text.data() + text.size(), value);
  return fault == std::errc() && end == text.data() + text.size() && std::isfinite(value);
}

void add_unit_option(CLI::App& command, std::string& unit) {
  command.add_option("--unit", unit, "Unit of mesh files that state none: mm, cm, m or in (m)");
}

Result<FileUnit> parse_unit(const std::string& unit) {
  if (const auto named = unit_named(unit)) return *named;
  return bad_input("--unit: \"" + unit + "\" is not a valid value; the values are: mm, cm, m, in");
}

std::string check_number(const std::string& text, const NumberRange& range, bool whole) {
  double number = 0;
  const std::string kind = whole ? "a whole number " : "a number ";
  const std::string_view digits = std::string_view(text).substr(text.starts_with('+') ? 1 : 0);
  if (!parse_number(digits, number) || (whole && number != std::floor(number)))
    return "must be " + kind + limits_text(range);
  return range.contains(number) ? "" : out_of_limits(number, range);
}

std::string without_leading_zeros(std::string text) {
  const size_t sign = text.starts_with('+') || text.starts_with('-') ? 1 : 0;
  const auto is_digit = [&](size_t i) { return i < text.size() && text[i] >= '0' && text[i] <= '9'; };
  size_t zeros = 0;
  while (is_digit(sign + zeros + 1) && text[sign + zeros] == '0') ++zeros;
  return text.erase(sign, zeros);
}

std::filesystem::path resolved(const std::filesystem::path& file) {
  std::error_code error;
  std::filesystem::path found = std::filesystem::absolute(file, error);
  if (!error) found = std::filesystem::weakly_canonical(found, error);
  return error ? file : found;
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

Result<KnifePlane> parse_plane(const std::string& text) {
  const auto wrong = bad_input("--plane: " + text +
                               ": must be NX,NY,NZ,D, four finite numbers with a normal that is not zero");
  std::array<double, 4> numbers{};
  std::string_view rest = text;
  for (size_t i = 0; i < 4; ++i) {
    const size_t comma = rest.find(',');
    if ((i < 3) == (comma == std::string_view::npos)) return wrong;
    if (!parse_number(rest.substr(0, comma), numbers[i])) return wrong;
    if (i < 3) rest.remove_prefix(comma + 1);
  }
  const Vec3 normal(numbers[0], numbers[1], numbers[2]);
  if (normal == Vec3(0)) return wrong;
  return KnifePlane{normal, numbers[3]};
}

void PictureArguments::add_to(CLI::App& command, CLI::Option* needed) {
  const auto add = [&](const char* name, std::string& text, const std::string& help) {
    CLI::Option* const option = command.add_option(name, text, help);
    if (needed != nullptr) option->needs(needed);
  };
  add("--size", size, "Width and height in pixels, WxH (1280x720)");
  add("--eye", eye, "Camera position, x,y,z in metres");
  add("--target", target, "Point at the centre of the view, x,y,z in metres");
  add("--section", section,
      "Section plane, \"x,y,z x,y,z\": point and normal, as copied in the editor; hides the side of the "
      "normal");
  add("--show", show,
      "Overlays, separated by commas (those of the scene, or shadows): " + offered_show_names());
}

Result<PictureOptions> PictureArguments::parse() const {
  PictureOptions options;
  const auto pixels = parse_size(size);
  if (!pixels) return pixels.error();
  options.width = pixels->width;
  options.height = pixels->height;
  if (!eye.empty()) {
    if (const Status s = unpack(parse_point("--eye", eye), options.eye); !s) return s.error();
  }
  if (!target.empty()) {
    if (const Status s = unpack(parse_point("--target", target), options.target); !s) return s.error();
  }
  if (options.eye && options.eye == options.target)
    return bad_input("--eye and --target: must differ");
  if (const Status s = unpack(parse_show_list(show), options.show); !s)
    return bad_input("--show: " + s.error().message);
  if (!section.empty()) {
    const auto plane = parse_section(section);
    if (!plane) return bad_input("--section: " + plane.error().message);
    options.section = *plane;
  }
  return options;
}

Status show_as_asked(const PictureArguments& arguments, const Scene& scene, const std::string& file,
                     PictureOptions& options) {
  if (arguments.show.empty()) {
    const auto wanted = parse_show_list(scene.show);
    if (!wanted) return bad_input(file + ": /show: " + wanted.error().message);
    options.show = scene.show.empty() ? default_show() : *wanted;
  }
  options.show.section = options.show.section || options.section.has_value();
  return Done{};
}

Status check_picture_name(const std::string& option, const std::string& file) {
  std::string ending = std::filesystem::path(file).extension().string();
  std::transform(ending.begin(), ending.end(), ending.begin(),
                 [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; });
  if (ending.empty() || ending == ".png") return Done{};
  return bad_input(option + ": " + file + ": images are written as PNG only; use a name that ends in .png");
}

}  // namespace kerf
