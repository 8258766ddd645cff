#pragma once

#include <optional>
#include <vector>

#include "ui/editor/shared/standard_view.h"
#include "ui/editor/shared/view_state.h"

struct ImDrawList;

namespace kerf {

// The axes of the world in the upper right corner of the first half of the picture. A click on the end of an
// axis looks from there; a drag turns the view. Places are of the window, screen coordinates.

// An end of an axis.
struct AxisEnd {
  StandardView view;  // along the axis, from this end
  int axis = 0;       // 0: X, 1: Y, 2: Z
  bool positive = true;
  Vec2 at{0};
  double depth = 0;  // grows away from the eye, -1 to 1
};

// The six ends, the farthest first; none where the picture is too small for them.
std::vector<AxisEnd> axis_ends(const ViewState& view);

// Whether a place belongs to the gizmo.
bool is_on_axes(const ViewState& view, Vec2 at);
// The nearest end of an axis at a place, if any.
std::optional<AxisEnd> axis_end_under(const ViewState& view, Vec2 at);

// The name of an end, as tests know it: "axis X", "axis -Y".
std::string name_of(const AxisEnd& end);

// Draws the gizmo, the end under the pointer highlighted, and below it what kind of view is shown.
void draw_axes_gizmo(const ViewState& view, Vec2 pointer, ImDrawList& list);

}  // namespace kerf
