#pragma once

#include <span>

#include "ui/editor/editor_state.h"
#include "ui/window/window.h"

namespace kerf {

// What the mouse does in the picture: left drag cuts or, with the tool that picks or Ctrl held, a click
// chooses the piece there; middle or Alt+left drag orbits, Shift+middle or right drag pans, the wheel zooms
// to the pointer. A drag belongs to where it began and goes on across panels. `free` says that no panel or
// menu wants the mouse.
void handle_mouse(EditorState& state, const InputEvent& event, bool free);

// Ends the stroke that runs, if one does; what was cut stays cut.
bool cancel_stroke(EditorState& state);

// Splits the picture in two or makes it one again; a stroke that is being drawn ends.
void show_split(EditorState& state, bool shown);

}  // namespace kerf
