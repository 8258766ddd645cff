#pragma once

#include <string>

namespace kerf {

class Fields;

// Does the step of the history again that was taken back last.
struct Redo {
  static constexpr const char* kName = "redo";
  std::string words() const { return "Redo"; }
  size_t weight() const { return 0; }
};
inline void describe(Fields&, Redo&) {}

}  // namespace kerf
