#pragma once

#include <cstddef>
#include <limits>
#include <string>

namespace kerf {

// A number with grouped digits: "12 345 678".
std::string grouped(size_t number);

// "1 stroke", "3 strokes", "1 234 faces", for a word of which the plural ends in "s".
std::string count_text(size_t count, const std::string& word);

// A unit of length: its symbol and its size in metres.
struct LengthUnit {
  const char* name;
  double metres;
};
// The largest unit from nm to km that does not exceed the length; nm for shorter lengths.
LengthUnit unit_for(double metres);

// The length in that unit, with three significant digits: "2.75 mm".
std::string length_text(double metres);

// The range of the numbers that a saved value may have; both ends belong to it.
struct NumberRange {
  double least, most;
  const char* unit = "";  // in which the number is saved, for errors
  bool positive = false;  // zero and below are refused in words of their own

  constexpr bool contains(double x) const { return x >= least && x <= most; }
};

inline constexpr NumberRange kFinite{std::numeric_limits<double>::lowest(),
                                     std::numeric_limits<double>::max()};
inline constexpr NumberRange kPositive{std::numeric_limits<double>::denorm_min(),
                                       std::numeric_limits<double>::max(), "", true};
inline constexpr NumberRange kPositiveShare{std::numeric_limits<double>::denorm_min(), 1, "", true};
inline constexpr NumberRange kShare{0, 1};

// What a missing key stands for, for ever: what Kerf did before the key existed, whatever the default of new
// work is. A command that lacks a key that every version wrote is damaged.
struct MissingKey {
  double value;
  bool always_written;
};
constexpr MissingKey always_written(double value) { return {value, true}; }
constexpr MissingKey added_later(double value) { return {value, false}; }

// A number of a saved type: what its readers, its writers and its row in a panel know of it.
template <typename Owner>
struct NumberField {
  const char* name;  // of the member, and in assets/materials.json
  const char* key;   // in scenes and journals
  double Owner::*member;
  NumberRange range;
  MissingKey missing;
  // In the panel, which does not have what has no label: the number is shown in a unit of this size.
  const char* label = nullptr;
  double scale = 1;
  const char* format = "";   // with the unit that is shown
  const char* meaning = "";  // for the user
};

}  // namespace kerf
