#include "ui/window/fitted_text.h"

#include <imgui.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <cstdlib>

#include "ui/window/number_text.h"
#include "ui/window/property.h"

namespace kerf {

namespace {

constexpr const char* kEllipsis = "...";
constexpr int kMostDigits = 6;

// Whether a character of UTF-8 begins at this byte.
bool begins_character(char c) { return (static_cast<unsigned char>(c) & 0xc0u) != 0x80u; }

// "1.2e+05" as "1.2e5".
std::string compact(std::string number) {
  const size_t e = number.find('e');
  if (e == std::string::npos) return number;
  size_t digits = e + 1;
  if (number[digits] == '+') number.erase(digits, 1);
  if (number[digits] == '-') ++digits;
  while (digits + 1 < number.size() && number[digits] == '0') number.erase(digits, 1);
  return number;
}

std::string with_digits(double value, int digits) {
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), "%.*g", digits, value);
  return compact(text.data());
}

}  // namespace

float width_of_text(std::string_view text) {
  return ImGui::CalcTextSize(text.data(), text.data() + text.size()).x;
}

std::string fitted_text(std::string_view text, float width, const TextWidth& width_of) {
  if (width_of(text) <= width) return std::string(text);
  const float room = width - width_of(kEllipsis);
  if (room < 0) return "";
  // The longest beginning that fits, by bisection: it is wider, the longer it is.
  size_t fits = 0, too_long = text.size();
  while (too_long - fits > 1) {
    size_t middle = (fits + too_long) / 2;
    while (middle > fits && !begins_character(text[middle])) --middle;
    if (middle == fits) {
      middle = (fits + too_long) / 2;
      while (middle < too_long && !begins_character(text[middle])) ++middle;
      if (middle == too_long) break;
    }
    (width_of(text.substr(0, middle)) <= room ? fits : too_long) = middle;
  }
  while (fits > 0 && text[fits - 1] == ' ') --fits;
  return std::string(text.substr(0, fits)) + kEllipsis;
}

std::string fitted_number(double value, const RealFormat& format, std::string_view unit, double scale,
                          float width, const TextWidth& width_of) {
  std::string text = number_text(value, format, scale) + std::string(unit);
  if (width_of(text) <= width) return text;
  // The digits of the number as it is shown, so that shortening it does not show more.
  char* suffix = nullptr;
  const std::string full = text;
  const double shown = std::strtod(full.c_str(), &suffix);
  if (suffix == full.c_str()) return fitted_text(full, width, width_of);
  for (const std::string& end : {std::string(suffix), std::string()}) {
    for (int digits = kMostDigits; digits > 0; --digits) {
      text = with_digits(shown, digits) + end;
      if (width_of(text) <= width) return text;
    }
  }
  return kEllipsis;
}

std::string visible_part(const std::string& label) { return label.substr(0, label.find("##")); }

std::string fitted_label(const std::string& label, float width) {
  const std::string seen = visible_part(label), fitted = fitted_text(seen, width);
  if (fitted == seen) return label;
  const size_t id = label.find("###");
  return fitted + "###" + (id == std::string::npos ? label : label.substr(id + 3));
}

bool begin_fitted_combo(const char* id, const std::string& preview) {
  const float room = ImGui::CalcItemWidth() - ImGui::GetFrameHeight() - 2 * ImGui::GetStyle().FramePadding.x;
  return ImGui::BeginCombo(id, fitted_text(preview, room).c_str());
}

void draw_fitted_text(const std::string& text, const char* meaning, float width) {
  const float room = width > 0 ? width : ImGui::GetContentRegionAvail().x;
  const std::string fitted = fitted_text(text, room);
  ImGui::TextUnformatted(fitted.c_str());
  if (fitted != text) {
    tooltip(meaning != nullptr ? (text + '\n' + meaning).c_str() : text.c_str());
  } else if (meaning != nullptr) {
    tooltip(meaning);
  }
}

}  // namespace kerf
