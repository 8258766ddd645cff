#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

namespace kerf {

// Parsing of numbers in mesh files, independent of the locale.

// The value of a word that is expected to be a number. A leading '+' and all spellings of nan and inf,
// including 1.#IND, are accepted; numbers too large for a double give infinity, numbers too small give zero.
// A word that consists of digits, signs, points and exponent letters but is no number ("3.1+e2") is a garbled
// number and gives NaN. Returns nothing for any other word.
std::optional<double> parse_number(std::string_view word);

// The value of a word that is expected to be an integer, clamped to 64 bits. Returns nothing for any other
// word.
std::optional<int64_t> parse_integer(std::string_view word);

// Whether the text starts like the rest of "1.#IND", "1.#INF", "1.#QNAN" or "1.#SNAN" from the '#' on:
// Microsoft's C library printed non-finite numbers in this form before 2015.
bool continues_microsoft_nan(std::string_view text);

}  // namespace kerf
