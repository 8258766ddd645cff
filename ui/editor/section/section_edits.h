#pragma once

#include "ui/editor/shared/view_state.h"
#include "ui/window/message.h"

namespace kerf {

// What people do with the section plane by name. Each shows the plane if it was not shown.

// Sets the plane through the middle of the world if it is shown and stands nowhere yet.
void place_section(ViewState& view, const World& world);

// Shows what was taken away, and takes away what was shown.
void flip_section(ViewState& view);
// Turns the plane about its point: across an axis of the world (0: X, 1: Y, 2: Z), with the eye on the side
// that is taken away, or parallel to the picture. Precondition: the plane is placed.
void turn_section_across(ViewState& view, int axis);
void turn_section_to_view(ViewState& view);

// The plane as text in the clipboard, and back; see section_text().
void copy_section(const ViewState& view, Message& message);
void paste_section(ViewState& view, Message& message);

}  // namespace kerf
