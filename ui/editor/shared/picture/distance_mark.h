#pragma once

#include <string>

#include "ui/editor/shared/picture/view_state.h"

struct ImDrawList;

namespace kerf {

// Marks of what was measured, in the first half of the picture. A mark with a point behind the eye is not
// drawn.

// Draws a point of the world (m) that was clicked.
void draw_measured_point(const ViewState& view, const Vec3& point, ImDrawList& list);
// Draws the line between two points, with `text` above its middle.
void draw_distance(const ViewState& view, const Vec3& from, const Vec3& to, const std::string& text,
                   ImDrawList& list);

}  // namespace kerf
