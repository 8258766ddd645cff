#pragma once

#include "core/document/history/document.h"

namespace kerf {

// Stops what the beam is at: the stroke that is being executed ends where it is, and those that wait behind
// it are undone, so that they can be redone. Also undoes a stroke of which nothing was executed. Does nothing
// if no moves wait.
Outcome stop_strokes(Document& document);

}  // namespace kerf
