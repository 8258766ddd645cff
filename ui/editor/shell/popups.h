#pragma once

namespace kerf {

// Whether a menu, the list of a combo or the popup of a right click is open. Modal windows do not count.
// Precondition: called between the beginning of an ImGui frame and its end, as are the others.
bool is_popup_open();

// Closes all of them, submenus included: one that stayed open would open its submenu again under the pointer.
void close_popups();

// Whether the pointer is over a panel, a bar, a menu or a dialog.
bool pointer_is_over_panel();

}  // namespace kerf
