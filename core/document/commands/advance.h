#pragma once

#include <string>

#include "core/base/tick.h"

namespace kerf {

class Fields;

// Lets time pass: so many ticks (see core/base/tick.h). It does not end a running stroke; it takes effect
// when the moves before it are walked. All that changes in a world by itself changes here.
struct Advance {
  Ticks ticks = 0;
  bool bodies = false;  // bodies move (see core/physics), which Play begins
  // Belongs to the step of the history before it whatever that is, and is undone with it. Time that does not
  // is a step of its own after an edit (see Document).
  bool joins = false;

  static constexpr const char* kName = "advance";
  // The largest number in one line of a journal: each second of a run is a line of its own.
  static constexpr Ticks kMostInALine = kTicksPerSecond;

  std::string words() const;
  size_t weight() const { return 0; }
};
void describe(Fields& f, Advance& c);

}  // namespace kerf
