#include "core/base/number_format.h"

#include <array>
#include <charconv>
#include <cmath>

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

std::string general_text(double number, int digits) {
  std::array<char, 32> text{};
  const auto end =
      std::to_chars(text.data(), text.data() + text.size(), number, std::chars_format::general, digits);
  return {text.data(), end.ptr};
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
  return general_text(metres / unit.metres, 3) + ' ' + unit.name;
}

}  // namespace kerf
