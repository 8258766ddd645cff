#pragma once

#include <string>

namespace kerf {

class Fields;

// Takes the last step of the history back; a stroke with all its moves is one step.
struct Undo {
  static constexpr const char* kName = "undo";
  std::string words() const { return "Undo"; }
  size_t weight() const { return 0; }
};
inline void describe(Fields&, Undo&) {}

}  // namespace kerf
