#pragma once

#include "ui/editor/editor_state.h"

namespace kerf {

// The F1 sheet: gestures and shortcuts, from their tables.
void draw_shortcut_sheet(EditorState& state);

}  // namespace kerf
