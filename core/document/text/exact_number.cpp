#include "core/document/text/exact_number.h"

#include <array>
#include <charconv>
#include <cmath>

#include "core/base/assert.h"

namespace kerf {

void append_number(std::string& text, double x) {
  KERF_ASSERT(std::isfinite(x));
  std::array<char, 32> digits{};
  const auto end = std::to_chars(digits.data(), digits.data() + digits.size(), x).ptr;
  const std::string_view number(digits.data(), static_cast<size_t>(end - digits.data()));
  text += number;
  if (number.find_first_of(".e") == std::string_view::npos) text += ".0";
}

}  // namespace kerf
