#pragma once

#include <string>

namespace kerf {

// The unit in which a length reads best: its name and its size in metres.
struct LengthUnit {
  const char* name;
  double metres;
};
LengthUnit unit_for(double metres);

// "2.75 mm"
std::string length_text(double metres);

}  // namespace kerf
