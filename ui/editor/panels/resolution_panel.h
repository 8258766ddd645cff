#pragma once

#include "ui/editor/editor_state.h"

namespace kerf {

// How finely faces are split under the beam, from coarse to fine; moving a slider cuts the last stroke again.
void draw_resolution_panel(EditorState& state);

}  // namespace kerf
