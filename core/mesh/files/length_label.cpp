#include "core/mesh/files/length_label.h"

#include <array>
#include <cstdio>

namespace kerf {

std::string length_label(double length, FileUnit unit) {
  const LengthUnit shown = label_unit(length, unit);
  std::array<char, 48> text{};
  std::snprintf(text.data(), text.size(), "%.3g %s", length / shown.metres, shown.name);
  return text.data();
}

LengthUnit label_unit(double length, FileUnit unit) {
  if (unit == FileUnit::kInch) return {"in", 1};
  const double metres = metres_per_unit(unit);
  const LengthUnit shown = unit_for(length * metres);
  return {shown.name, shown.metres / metres};
}

}  // namespace kerf
