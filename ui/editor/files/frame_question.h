#pragma once

#include "ui/editor/shared/picture/view_state.h"
#include "ui/editor/shared/settings/settings.h"

namespace kerf {

// Asks at the right border of the picture, under the axes, for the unit and the upward axis of a mesh file
// that was opened, with what was guessed chosen already, and says how large the world (of this `size`, in the
// numbers of the file) is then, and in the unit that is mistaken most often for it. Nothing waits for an
// answer: the question goes when a stroke begins (`cut_once`), and is asked once for each kind of file if it
// is answered. Draws nothing where nothing is to be asked.
void draw_frame_question(const Vec3& size, ViewState& view, Settings& settings, bool cut_once);

}  // namespace kerf
