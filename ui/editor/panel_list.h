#pragma once

#include <vector>

#include "ui/editor/panels/panel_column.h"
#include "ui/editor/state.h"

namespace kerf {

// The panels of the column at the right, from top to bottom, each bound to the parts of the state that it
// shows and changes. The state must outlive them.
std::vector<Panel> make_panels(EditorState& state);

}  // namespace kerf
