#pragma once

#include "core/document/journal/journal.h"

namespace kerf {

class Fields;

// A mark of a journal. Where bodies have moved it has "machine", "clock" and
//   "bodies": [{"body": [slot, generation], "position", "orientation", "velocity", "spin", "quiet",
//   "asleep"}] "pairs": [[slot, generation, slot, generation, touching, crossed]], without the second body
//   for the ground:
//     1 where the two touch, and for how many ticks they have intersected. They are read back sorted.
// Numbers come back to the bit.
void describe(Fields& f, StateMark& mark);

}  // namespace kerf
