#pragma once

#include "ui/editor/editor_state.h"

namespace kerf {

// Over the lower edge of the picture: what is being done, how far it is, and a button that stops it where it
// can be stopped. Whether that was pressed.
bool draw_progress(const Area& picture, const std::string& title, double fraction, bool can_stop);

// The same for files that are being read. Nothing where nothing is read.
void draw_load_bar(EditorState& state);

// Gives up what is being read; what is open stays as it is.
void cancel_opening(EditorState& state);

}  // namespace kerf
