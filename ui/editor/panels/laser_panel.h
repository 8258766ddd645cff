#pragma once

#include "ui/editor/editor_state.h"

namespace kerf {

// Radius and pattern of the beam.
void draw_laser_panel(EditorState& state);

}  // namespace kerf
