#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "ui/editor/shared/viewport.h"
#include "ui/render/view/camera.h"
#include "ui/window/layout.h"

struct ImDrawList;

namespace kerf {

// A handle in the first half of the picture, by which the pointer moves or turns something of the world: an
// arrow, the half of a ring that is in front, or a single point. Places are of the window, screen
// coordinates.
struct GizmoHandle {
  // `points` are of the world (m). A handle with a point behind the eye has no places: it is neither drawn
  // nor found.
  GizmoHandle(const FirstPicture& picture, std::string its_name, std::vector<Vec3> its_points,
              size_t its_grip = 0);

  std::string name;  // as tests know it; unique among the handles of one thing
  std::vector<Vec3> points;
  std::vector<Vec2> places;  // of the points
  size_t grip = 0;           // the point that the name stands for
  // Places this near to the first point, as a share of an arrow's length, do not belong to it: there lies
  // what the arrow moves.
  double free_share = 0;
};

// The points of an arrow, and of the half of a ring that is in front. Its length and its radius are given in
// sizes of the text, so that handles are equally large at every distance. `u` and `v` are perpendicular unit
// vectors in the plane of the ring. Precondition: the first point or the
// middle is in front of the eye.
std::vector<Vec3> gizmo_arrow(const FirstPicture& picture, const Vec3& from, const Vec3& direction,
                              double ems);
std::vector<Vec3> gizmo_ring(const FirstPicture& picture, const Vec3& middle, const Vec3& u, const Vec3& v,
                             double ems);
// The number of points of a ring. The point in its middle is the nearest to the eye.
inline constexpr size_t kGizmoRing = 65;

// The point of a handle that is seen nearest to a place of the window, and how far from it.
struct GizmoPoint {
  double distance = INFINITY;
  Vec3 point{0};  // m
};
GizmoPoint nearest_point(const GizmoHandle& handle, Vec2 at);

// The handle at a place of the window, if any: the last one of the nearest. `Handle` is a GizmoHandle.
template <typename Handle>
std::optional<Handle> handle_under(const std::vector<Handle>& handles, Vec2 at) {
  constexpr double kHandleReach = 8;  // screen coordinates
  const Handle* found = nullptr;
  double least = kHandleReach;
  for (const Handle& handle : handles) {
    const double distance = nearest_point(handle, at).distance;
    if (distance > least) continue;
    least = distance;
    found = &handle;
  }
  return found != nullptr ? std::optional(*found) : std::nullopt;
}

// Names the places of handles, for tests.
template <typename Handle>
void mark_handles(const std::vector<Handle>& handles, Landmarks& landmarks) {
  for (const GizmoHandle& handle : handles) {
    if (!handle.places.empty()) landmarks.mark(handle.name, {handle.places[handle.grip], Vec2(0)});
  }
}

// A handle at the end of a line from `pivot` that is dragged around it: the point at this distance (m, > 0)
// from the pivot that is seen at `place`, or nearest to it, on the side of the pivot, towards the eye or away
// from it, on which `now` is.
Vec3 dragged_around(const FirstPicture& picture, const Vec3& pivot, double distance, const Vec3& now,
                    Vec2 place);

// How far (m) a point of the line through `at` (a unit vector `axis` points along it) goes with the pointer
// while the ray through the pointer goes from one to another; the point is the nearest of the line to the
// ray. 0 where the line is seen nearly from its end and so cannot be followed.
double dragged_along(const Pose& from, const Pose& to, const Vec3& at, const Vec3& axis);

// Draws an arrow or a ring with a dark rim, so that it is seen on every ground. `em` is the size of the text,
// the colour is an ImU32.
void draw_handle(const GizmoHandle& handle, double em, uint32_t colour, ImDrawList& list);

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

// Marks of what was measured, in the first half of the picture. A mark with a point behind the eye is not
// drawn.

// Draws a point of the world (m) that was clicked.
void draw_measured_point(const ViewState& view, const Vec3& point, ImDrawList& list);
// Draws the line between two points, with `text` above its middle.
void draw_distance(const ViewState& view, const Vec3& from, const Vec3& to, const std::string& text,
                   ImDrawList& list);

}  // namespace kerf
