#pragma once

#include <string>

#include "core/base/tick.h"

namespace kerf {

class Fields;

// Ends the last stroke earlier than it was drawn: the beam goes off at a place of its path. It is for strokes
// that take long to cut, and belongs to the step of the stroke.
struct StopStroke {
  // The moves of the beam that are cut, of which the first one only switches it on: 12.5 are twelve moves and
  // the first half of the next one, rounded to the parts into which it is subdivided.
  double moves = 0;
  Ticks ticks = 0;  // after those, for which the beam stays on while bodies move

  static constexpr const char* kName = "stop";
  std::string words() const { return "Stop the stroke"; }
  size_t weight() const { return 0; }
};
void describe(Fields& f, StopStroke& c);

}  // namespace kerf
