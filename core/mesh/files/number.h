#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

namespace kerf {

// Numbers as mesh files write them, whatever the locale is.

// The value of a word that must be a number. A leading '+', nan and inf in all their spellings (1.#IND too)
// are numbers; what is too large for a double is infinite, what is too small is zero. A word of nothing but
// digits, signs, points and exponents in a wrong order ("3.1+e2") is a garbled number and gives NaN. Nothing
// for any other word.
std::optional<double> parse_number(std::string_view word);

// The value of a word that must be an integer; beyond 64 bits the nearest there is. Nothing for any other
// word.
std::optional<int64_t> parse_integer(std::string_view word);

// Whether text goes on as "1.#IND" and its kin do from the '#' on: what Microsoft's C library printed for
// numbers that are not finite before 2015.
bool continues_microsoft_nan(std::string_view text);

}  // namespace kerf
