#pragma once

#include <vector>

#include "core/document/journal/journal.h"

namespace kerf {

// Commands of a journal that only let bodies move, and the mark that says where this brought them: whoever
// replays the journal may put them there, and comes to the same.
struct TimeSkip {
  size_t first = 0;  // the first of these commands
  size_t mark = 0;   // index in Journal::marks
  Ticks ticks = 0;   // that pass until then
};

// The runs of at least `least` ticks that can be skipped, in their order. A run begins with Play, or where
// the stroke before it ends, and ends at the last mark in it from which bodies go on to the bit: where the
// step of the history is over, or at a full minute (see Execution::kTicksToForget).
std::vector<TimeSkip> time_skips(const Journal& journal, Ticks least);

}  // namespace kerf
