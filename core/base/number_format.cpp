#include "core/base/number_format.h"

#include <array>
#include <cmath>
#include <cstdio>

namespace kerf {

std::string grouped(size_t number) {
  std::string digits = std::to_string(number);
  for (auto at = static_cast<std::ptrdiff_t>(digits.size()) - 3; at > 0; at -= 3)
    digits.insert(static_cast<size_t>(at), " ");
  return digits;
}

std::string count_text(size_t count, const std::string& word) {
  return grouped(count) + ' ' + word + (count == 1 ? "" : "s");
}

LengthUnit unit_for(double metres) {
  constexpr std::array<LengthUnit, 5> kUnits{
      {{"nm", 1e-9}, {"\xc2\xb5m", 1e-6}, {"mm", 1e-3}, {"m", 1}, {"km", 1000}}};
  constexpr double kRoundsToOne = 0.9995;
  LengthUnit best = kUnits.front();
  for (const LengthUnit& unit : kUnits) {
    if (std::abs(metres) >= kRoundsToOne * unit.metres) best = unit;
  }
  return best;
}

std::string length_text(double metres) {
  const LengthUnit unit = unit_for(metres);
  std::array<char, 48> text{};
  std::snprintf(text.data(), text.size(), "%.3g %s", metres / unit.metres, unit.name);
  return text.data();
}

}  // namespace kerf
