#pragma once

#include <memory>

#include "ui/editor/shared/workspace.h"

namespace kerf {

// What a press in the picture begins that chooses pieces: a click chooses the piece under the pointer, a drag
// those in a box; with Shift they are added to those that are chosen.
std::unique_ptr<Interaction> press_on_pieces(Workspace& on);

}  // namespace kerf
