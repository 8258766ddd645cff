#pragma once

#include <optional>

#include "ui/editor/shared/workspace.h"

struct ImDrawList;

namespace kerf {

// Draws over the picture what there is to know about the face under the pointer, in a box beside it, and the
// face's edges.
void draw_face_readout(const Workspace& on, ImDrawList& list);

// Draws points that were clicked to measure, and the distance of two.
void draw_measure(const ViewState& view, const std::vector<Vec3>& points, ImDrawList& list);

}  // namespace kerf
