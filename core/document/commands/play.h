#pragma once

#include <string>

namespace kerf {

class Fields;

// Begins a step of the history in which bodies move: the Advance commands that follow, up to the next stroke
// or edit, belong to it and are undone with it.
struct Play {
  static constexpr const char* kName = "play";
  std::string words() const { return "Play"; }
  size_t weight() const { return 0; }
};
inline void describe(Fields&, Play&) {}

}  // namespace kerf
