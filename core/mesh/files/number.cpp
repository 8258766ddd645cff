#include "core/mesh/files/number.h"

#include <algorithm>
#include <charconv>
#include <limits>

namespace kerf {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

bool is_digit(char c) { return c >= '0' && c <= '9'; }

// std::from_chars takes no '+'.
std::string_view without_plus(std::string_view word) {
  if (word.size() > 1 && word[0] == '+' && word[1] != '-' && word[1] != '+') word.remove_prefix(1);
  return word;
}

// The value of a number outside the range of double: infinity or zero, decided by the decimal exponent of its
// first significant digit.
double out_of_range_value(std::string_view word) {
  const bool negative = word.starts_with('-');
  if (negative) word.remove_prefix(1);
  const size_t exponent_at = std::min(word.find_first_of("eE"), word.size());
  const std::string_view mantissa = word.substr(0, exponent_at);
  const size_t point = std::min(mantissa.find('.'), mantissa.size());
  const size_t first = std::min(mantissa.find_first_of("123456789"), mantissa.size());
  const int64_t exponent = parse_integer(word.substr(std::min(exponent_at + 1, word.size()))).value_or(0);
  const int64_t shift = static_cast<int64_t>(point) - static_cast<int64_t>(first);
  const double magnitude = exponent > -shift ? kInfinity : 0.0;
  return negative ? -magnitude : magnitude;
}

bool is_garbled_number(std::string_view word) {
  return word.find_first_not_of("0123456789+-.eE") == std::string_view::npos &&
         std::any_of(word.begin(), word.end(), is_digit);
}

}  // namespace

bool continues_microsoft_nan(std::string_view text) {
  return text.starts_with("#IND") || text.starts_with("#INF") || text.starts_with("#QNAN") ||
         text.starts_with("#SNAN");
}

std::optional<double> parse_number(std::string_view word) {
  const std::string_view digits = without_plus(word);
  const char* const end = digits.data() + digits.size();
  double value = 0;
  const auto [stop, code] = std::from_chars(digits.data(), end, value);
  if (stop == end && code == std::errc()) return value;
  if (stop == end && code == std::errc::result_out_of_range) return out_of_range_value(digits);
  if (continues_microsoft_nan({stop, end}) || is_garbled_number(word)) return kNaN;
  return std::nullopt;
}

std::optional<int64_t> parse_integer(std::string_view word) {
  const std::string_view digits = without_plus(word);
  const char* const end = digits.data() + digits.size();
  int64_t value = 0;
  const auto [stop, code] = std::from_chars(digits.data(), end, value);
  if (stop != end || code == std::errc::invalid_argument) return std::nullopt;
  if (code == std::errc()) return value;
  return digits.starts_with('-') ? std::numeric_limits<int64_t>::min() : std::numeric_limits<int64_t>::max();
}

}  // namespace kerf
