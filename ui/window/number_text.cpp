#include "ui/window/number_text.h"

#include <array>
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

std::string text_of(const char* format, ...) {
  std::array<char, 256> text{};
  std::va_list values;
  va_start(values, format);
  std::vsnprintf(text.data(), text.size(), format, values);
  va_end(values);
  return text.data();
}

}  // namespace kerf
