#pragma once

#include <cstddef>
#include <limits>
#include <string>

namespace kerf {

// Formats a number with grouped digits: "12 345 678".
std::string grouped(size_t number);

// Formats a count: "1 stroke", "3 strokes", "1 234 faces". Precondition: the plural of the word ends in "s".
std::string count_text(size_t count, const std::string& word);

// Formats a number with at most this many significant digits, as "%g" of printf does in the C locale: "0.05",
// "1e-09". Precondition: 1 <= digits <= 17.
std::string general_text(double number, int digits);

// A unit of length: its symbol and its size in metres.
struct LengthUnit {
  const char* name;
  double metres;
};
// Returns the largest unit from nm to km that does not exceed the length, rounded to three significant
// digits; nm for shorter lengths.
LengthUnit unit_for(double metres);

// Formats a length in that unit, with three significant digits: "2.75 mm".
std::string length_text(double metres);

// The closed range of a saved number.
struct NumberRange {
  double least, most;
  const char* unit = "";  // unit of the saved number, for errors
  bool positive = false;  // zero and negative numbers get an error message of their own

  constexpr bool contains(double x) const { return x >= least && x <= most; }
};

inline constexpr NumberRange kFinite{std::numeric_limits<double>::lowest(),
                                     std::numeric_limits<double>::max()};
inline constexpr NumberRange kPositive{std::numeric_limits<double>::denorm_min(),
                                       std::numeric_limits<double>::max(), "", true};
inline constexpr NumberRange kPositiveShare{std::numeric_limits<double>::denorm_min(), 1, "", true};
inline constexpr NumberRange kShare{0, 1};

// The meaning of a missing key: permanently the behaviour of Kerf before the key existed, even if new
// documents have another default. A command is damaged if it lacks a key that every version wrote.
struct MissingKey {
  double value;
  bool always_written;
};
constexpr MissingKey always_written(double value) { return {value, true}; }
constexpr MissingKey added_later(double value) { return {value, false}; }

// A number of a saved type, as its readers and writers share it.
template <typename Owner>
struct NumberField {
  const char* name;  // of the member, and in assets/materials.json
  const char* key;   // in scenes and journals
  double Owner::*member;
  NumberRange range;
  MissingKey missing;
};

}  // namespace kerf
