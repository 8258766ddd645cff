#pragma once

#include "ui/editor/editor_state.h"

namespace kerf {

// What is drawn flat over the picture: the ring of the beam at the pointer, and the hints of the first
// minutes.
void draw_picture_marks(const EditorState& state);

}  // namespace kerf
