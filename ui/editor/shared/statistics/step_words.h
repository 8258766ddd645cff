#pragma once

#include <string>

#include "core/document/history/history.h"
#include "core/mesh/files/file_frame.h"

namespace kerf {

// What a step of the history is to people. Strokes are counted, and say what they cut and how: "Cut 2: roof,
// radius 4 mm", "Cut 2 again: roof, edges of 3 mm"; every other step says what its command does. `unit` is
// the one in which the work is shown. O(steps). Precondition: the history has the step.
std::string step_words(const History& history, size_t step, FileUnit unit);

}  // namespace kerf
