#pragma once

#include "ui/editor/view/view_state.h"
#include "ui/render/view_switches.h"

namespace kerf {

// Draws a switch of the view as a check box with its key and its tooltip. `label` stands in place of its own
// where the row says what is switched already. Returns whether it was flipped.
bool draw_switch(ViewState& view, SwitchId id, const char* label = nullptr);

}  // namespace kerf
