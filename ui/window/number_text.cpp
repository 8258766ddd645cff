#include "ui/window/number_text.h"

#include <imgui.h>
#include <imgui_internal.h>

#include <array>
#include <cmath>
#include <cstdarg>
#include <cstdio>

namespace kerf {

std::string area_text(double square_metres) {
  if (square_metres == 0) return "none";
  struct Unit {
    const char* name;
    double size;
  };
  constexpr std::array kUnits{Unit{"\xc2\xb5m\xc2\xb2", 1e-12}, Unit{"mm\xc2\xb2", 1e-6},
                              Unit{"cm\xc2\xb2", 1e-4}, Unit{"m\xc2\xb2", 1}};
  Unit best = kUnits.front();
  for (const Unit& unit : kUnits) {
    if (square_metres >= 0.1 * unit.size) best = unit;
  }
  std::array<char, 48> text{};
  const double value = square_metres / best.size;
  std::snprintf(text.data(), text.size(), value >= 100 ? "%.0f %s" : "%.3g %s", value, best.name);
  return text.data();
}

bool is_noise(double value, double scale) {
  constexpr double kNoise = 1e-12;
  return std::abs(value) < kNoise * std::abs(scale);
}

std::string number_text(double value, const RealFormat& format, double scale) {
  std::array<char, 256> text{};
  const double shown = is_noise(value, scale) ? 0 : value;
  ImGui::DataTypeFormatString(text.data(), static_cast<int>(text.size()), ImGuiDataType_Double, &shown,
                              format.c_str());
  std::string number = text.data();
  // A negative number that is rounded to 0 keeps its sign in printf.
  const size_t digit = number.find_first_of("0123456789");
  if (digit == std::string::npos || digit == 0 || number[digit - 1] != '-') return number;
  const size_t end = number.find_first_not_of("0.", digit);
  if (end == std::string::npos || std::string_view("123456789e").find(number[end]) == std::string_view::npos)
    number.erase(digit - 1, 1);
  return number;
}

std::string text_of(const char* format, ...) {
  std::array<char, 256> text{};
  std::va_list values;
  va_start(values, format);
  std::vsnprintf(text.data(), text.size(), format, values);
  va_end(values);
  return text.data();
}

}  // namespace kerf
