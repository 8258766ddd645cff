#pragma once

#include <optional>

#include "ui/editor/shared/workspace.h"
#include "ui/editor/shell/catalogue.h"
#include "ui/window/window.h"

namespace kerf {

// Returns true if a menu, the list of a combo or a context menu is open; modal windows do not count.
// Precondition of this and the next two: called within an ImGui frame.
bool is_popup_open();

// Closes all of them, including submenus: an open one would reopen its submenu under the pointer.
void close_popups();

// Returns true if the pointer is over a panel, a bar, a menu or a dialog.
bool pointer_is_over_panel();

// A press in the viewport that closed a popup. A following move makes it the start of a drag, so that a
// stroke begins where the button was pressed. A release without a move makes it a click that only closed the
// popup.
class DeferredPress {
 public:
  // Stores the press in place of an earlier one.
  void hold(const InputEvent& press) { held_ = press; }
  // Returns the press whose drag this event begins, once. Another press, or the release, drops it.
  std::optional<InputEvent> press_of(const InputEvent& event);

 private:
  std::optional<InputEvent> held_;
};

// Handles the mouse in the viewport: a press of the left button belongs to the first feature that claims it;
// middle or Alt+left drag orbits, Shift+middle or right drag pans, the wheel zooms to the pointer. A drag
// belongs to the place where it began, and continues across panels. `free`: no panel or menu uses the mouse.
void handle_mouse(Workspace& workspace, const Features& features, const InputEvent& event, bool free);

}  // namespace kerf
