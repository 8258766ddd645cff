#pragma once

#include <optional>

#include "ui/editor/tools/hand.h"
#include "ui/editor/view/view_state.h"

struct ImDrawList;

namespace kerf {

// Draws over the picture what there is to know about the face under the pointer, in a box beside it, and the
// face's edges; and the points that were clicked to measure, with their distance. Only with the tool that
// inspects.
void draw_face_readout(const ViewState& view, const Hand& hand, const World& world, ImDrawList& list);

}  // namespace kerf
