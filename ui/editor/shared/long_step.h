#pragma once

#include "core/document/history/document.h"

namespace kerf {

// Whether the world is so small that changes of its bodies take no longer than a part of a frame.
bool is_small(const Document& document);

// Whether a command takes no longer than that.
bool is_quick(const Document& document, const Command& command);

// What the next step of the document does, in a few words, if it takes so long that it has to run beside the
// frames because it makes bodies or colliders of many faces. Null for any other step. O(pieces).
const char* why_beside(const Document& document);

}  // namespace kerf
