#pragma once

#include "ui/editor/shared/view_state.h"
#include "ui/render/view/view_switches.h"

namespace kerf {

// Draws a switch of the view as a check box, or as radio buttons where it has more than two states, with its
// key and its tooltip. `label` replaces its own label in a row that has a name already. Returns whether its
// state was changed.
bool draw_switch(ViewState& view, SwitchId id, const char* label = nullptr);

}  // namespace kerf
