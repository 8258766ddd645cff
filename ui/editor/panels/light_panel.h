#pragma once

#include "ui/editor/editor_state.h"

namespace kerf {

// Lights, and how they cast shadows.
void draw_light_panel(EditorState& state);

}  // namespace kerf
