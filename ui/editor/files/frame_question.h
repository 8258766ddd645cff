#pragma once

#include "ui/editor/shared/settings.h"
#include "ui/editor/shared/view_state.h"

namespace kerf {

// Asks at the right border of the picture, under the axes, for the unit and the upward axis of a mesh file
// that was opened, with what was guessed chosen already. Nothing waits for an answer: the question goes when
// a stroke begins (`cut_once`), and is asked once for each kind of file if it is answered. Draws nothing
// where nothing is to be asked.
void draw_frame_question(ViewState& view, Settings& settings, bool cut_once);

}  // namespace kerf
