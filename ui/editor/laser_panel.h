#pragma once

#include "ui/editor/editor_state.h"

namespace kerf {

// Radius, resolution and pattern of the beam.
void draw_laser_panel(EditorState& state);

}  // namespace kerf
