#pragma once

#include <string>

namespace kerf {

class Fields;

// Ends the running stroke: the beam is off. A stroke with a smooth rim is smoothed here.
struct EndStroke {
  static constexpr const char* kName = "end";
  std::string words() const { return "End the stroke"; }
  size_t weight() const { return 0; }
};
inline void describe(Fields&, EndStroke&) {}

}  // namespace kerf
