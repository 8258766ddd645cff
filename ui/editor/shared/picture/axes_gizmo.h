#pragma once

#include <array>
#include <optional>
#include <vector>

#include "ui/editor/shared/picture/view_state.h"
#include "ui/render/view/camera.h"

struct ImDrawList;

namespace kerf {

// A view along an axis of the world, as on a technical drawing.
struct StandardView {
  const char* name;
  double yaw, pitch;  // of the eye, see Camera::turn_to
};

// In pairs that look at each other.
inline constexpr double kQuarterTurn = 1.5707963267948966;
inline constexpr std::array kStandardViews{
    StandardView{"Front", 0, 0},
    StandardView{"Back", 2 * kQuarterTurn, 0},
    StandardView{"Right", kQuarterTurn, 0},
    StandardView{"Left", -kQuarterTurn, 0},
    StandardView{"Top", 0, kQuarterTurn},
    StandardView{"Bottom", 0, -kQuarterTurn},
};

// The standard view that the camera shows or moves to, if it is one.
std::optional<StandardView> standard_view_of(const Camera& camera);

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
