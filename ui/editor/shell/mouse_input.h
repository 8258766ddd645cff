#pragma once

#include <optional>

#include "ui/editor/shared/workspace.h"
#include "ui/editor/shell/catalogue.h"
#include "ui/window/window.h"

namespace kerf {

// Whether a menu, the list of a combo or the popup of a right click is open. Modal windows do not count.
// Precondition: called between the beginning of an ImGui frame and its end, as are the others.
bool is_popup_open();

// Closes all of them, submenus included: one that stayed open would open its submenu again under the pointer.
void close_popups();

// Whether the pointer is over a panel, a bar, a menu or a dialog.
bool pointer_is_over_panel();

// A press of a mouse button in the picture that closed a popup. If the pointer then moves, it was the
// beginning of a drag, which must not be lost: a stroke begins where the button was pressed. If the button is
// released without a move, the click has done all that was wanted of it, and nothing is cut or chosen.
class HeldPress {
 public:
  // Keeps the press in place of an earlier one.
  void hold(const InputEvent& press) { held_ = press; }
  // The press whose drag this event begins, once. Any other press and the release of the button drop it.
  std::optional<InputEvent> press_of(const InputEvent& event);

 private:
  std::optional<InputEvent> held_;
};

// What the mouse does in the picture: a press of the left button belongs to the first feature that claims it;
// middle or Alt+left drag orbits, Shift+middle or right drag pans, the wheel zooms to the pointer. A drag
// belongs to where it began and goes on across panels. `free` says that no panel or menu wants the mouse.
void hear_mouse(Workspace& workspace, const Features& features, const InputEvent& event, bool free);

}  // namespace kerf
