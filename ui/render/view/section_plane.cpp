#include "ui/render/view/section_plane.h"

#include <charconv>
#include <cmath>
#include <limits>

#include "core/base/assert.h"
#include "core/document/text/json.h"
#include "ui/render/view/view_options.h"

namespace kerf {

namespace {

constexpr std::string_view kBlanks = " \t\r\n";
constexpr double kUnitLengthError = 1e-12;  // maximum error of the length of a unit vector

std::string_view trimmed(std::string_view text, std::string_view what) {
  const size_t first = text.find_first_not_of(what);
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(what) - first + 1);
}

// Takes one of three numbers from the front of a text, with the comma or the blanks before it.
bool take_number(std::string_view& text, double& value) {
  text.remove_prefix(std::min(text.find_first_not_of(kBlanks), text.size()));
  const auto [end, fault] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (fault != std::errc() || !std::isfinite(value)) return false;
  text.remove_prefix(static_cast<size_t>(end - text.data()));
  return true;
}

bool take_comma(std::string_view& text) {
  text.remove_prefix(std::min(text.find_first_not_of(kBlanks), text.size()));
  if (!text.starts_with(',')) return false;
  text.remove_prefix(1);
  return true;
}

bool take_vector(std::string_view& text, Vec3& v) {
  return take_number(text, v.x) && take_comma(text) && take_number(text, v.y) && take_comma(text) &&
         take_number(text, v.z);
}

void append(std::string& text, const Vec3& v) {
  for (int i = 0; i < 3; ++i) {
    if (i > 0) text += ',';
    append_number(text, v[i] + 0.0);  // without the sign of a zero
  }
}

}  // namespace

SectionPlane SectionPlane::facing(const Vec3& point, const Vec3& way) {
  const double largest = std::max({std::abs(way.x), std::abs(way.y), std::abs(way.z)});
  KERF_ASSERT(largest > 0);
  const bool unit =
      std::abs(glm::length(way) - 1) < kUnitLengthError;  // so that reading a plane back does not change it
  return {point, unit ? way : glm::normalize(way / largest)};
}

Interval SectionPlane::kept_along(const Pose& ray) const {
  constexpr double kEndless = std::numeric_limits<double>::max();
  const double height = height_of(ray.origin), rise = glm::dot(normal, ray.direction);
  if (rise == 0) return {0, height <= 0 ? kEndless : -1};
  const double meets = -height / rise;
  if (rise > 0) return {0, std::min(meets, kEndless)};
  return {std::max(meets, 0.0), kEndless};
}

SectionPlane section_through(const World::Bounds& bounds, const Vec3& to_eye) {
  int nearest = 0;
  for (int i = 1; i < 3; ++i) {
    if (std::abs(to_eye[i]) > std::abs(to_eye[nearest])) nearest = i;
  }
  SectionPlane plane{bounds.min + 0.5 * (bounds.max - bounds.min), Vec3(0)};
  plane.normal[nearest] = to_eye[nearest] < 0 ? -1 : 1;
  return plane;
}

const SectionPlane* shown_section(const ViewOptions& options) {
  return options.show.section && options.section ? &*options.section : nullptr;
}

std::string section_text(const SectionPlane& plane) {
  std::string text;
  append(text, plane.point);
  text += ' ';
  append(text, plane.normal);
  return text;
}

Result<SectionPlane> parse_section(std::string_view text) {
  const auto wrong =
      bad_input("a section plane needs a point and a normal, x,y,z x,y,z, such as \"0,0.5,0 0,1,0\"");
  constexpr std::string_view kOption = "--section";
  text = trimmed(text, kBlanks);
  if (text.starts_with(kOption)) text.remove_prefix(kOption.size());
  text = trimmed(text, " \t\r\n=\"'");
  SectionPlane plane;
  if (!take_vector(text, plane.point)) return wrong;
  if (text.empty() || kBlanks.find(text.front()) == std::string_view::npos) return wrong;
  if (!take_vector(text, plane.normal) || !trimmed(text, kBlanks).empty()) return wrong;
  if (plane.normal == Vec3(0)) return bad_input("the normal of a section plane must not be 0,0,0");
  return SectionPlane::facing(plane.point, plane.normal);
}

}  // namespace kerf
