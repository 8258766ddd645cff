#pragma once

#include <string>

namespace kerf {

// A unit of length: its symbol and its size in metres.
struct LengthUnit {
  const char* name;
  double metres;
};
// The largest unit from nm to km that does not exceed the length; nm for shorter lengths.
LengthUnit unit_for(double metres);

// The length in that unit, with three significant digits: "2.75 mm".
std::string length_text(double metres);

}  // namespace kerf
