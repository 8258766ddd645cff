#pragma once

#include "ui/editor/view/view_state.h"

namespace kerf {

// The switches of the view that have no panel of their own.
void draw_view_panel(ViewState& view);

}  // namespace kerf
