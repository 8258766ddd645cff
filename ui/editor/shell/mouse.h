#pragma once

#include "ui/editor/shared/workspace.h"
#include "ui/editor/shell/catalogue.h"

namespace kerf {

// What the mouse does in the picture: a press of the left button belongs to the first feature that claims it;
// middle or Alt+left drag orbits, Shift+middle or right drag pans, the wheel zooms to the pointer. A drag
// belongs to where it began and goes on across panels. `free` says that no panel or menu wants the mouse.
void hear_mouse(Workspace& on, const Features& features, const InputEvent& event, bool free);

}  // namespace kerf
