#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "ui/editor/shared/viewport.h"
#include "ui/render/view/camera.h"
#include "ui/window/layout.h"

struct ImDrawList;

namespace kerf {

// A handle in the first half of the viewport that moves or rotates something: an arrow, the front half of a
// ring, or a point. Places are in the window, screen coordinates.
struct GizmoHandle {
  // `points` are in world space [m]. With one behind the eye, a handle has no places: it is inactive.
  GizmoHandle(const PrimaryViewport& picture, std::string its_name, std::vector<Vec3> its_points,
              size_t its_grip = 0);

  std::string name;  // landmark of tests, unique among the handles of one object
  std::vector<Vec3> points;
  std::vector<Vec2> places;  // of the points
  size_t grip = 0;           // index of the point that the landmark names
  // Inactive share of an arrow's length at its first point, where the moved object lies.
  double free_share = 0;
};

// Compute the points of an arrow, and of the front half of a ring. `ems` is the length or the radius in
// sizes of the text, so that handles look equally large at every distance. `u` and `v` are perpendicular
// unit vectors in the plane of the ring. Precondition: the first point or the middle is in front of the eye.
std::vector<Vec3> gizmo_arrow(const PrimaryViewport& picture, const Vec3& from, const Vec3& direction,
                              double ems);
std::vector<Vec3> gizmo_ring(const PrimaryViewport& picture, const Vec3& middle, const Vec3& u, const Vec3& v,
                             double ems);
// Number of points of a ring. The middle one is the nearest to the eye.
inline constexpr size_t kGizmoRing = 65;

// The point of a handle that appears nearest to a place of the window, with its distance from there.
struct GizmoPoint {
  double distance = INFINITY;
  Vec3 point{0};  // m
};
GizmoPoint nearest_point(const GizmoHandle& handle, Vec2 at);

// Returns the handle at a place of the window, if any: the last of the nearest. `Handle`: a GizmoHandle.
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

// Adds the landmarks of handles, for tests.
template <typename Handle>
void mark_handles(const std::vector<Handle>& handles, Landmarks& landmarks) {
  for (const GizmoHandle& handle : handles) {
    if (!handle.places.empty()) landmarks.mark(handle.name, {handle.places[handle.grip], Vec2(0)});
  }
}

// Drags a handle around `pivot`: returns the point at this distance [m, > 0] from the pivot that appears at
// `place`, or nearest to it, on the same side of the pivot, towards the eye or away from it, as `now`.
Vec3 dragged_around(const PrimaryViewport& picture, const Vec3& pivot, double distance, const Vec3& now,
                    Vec2 place);

// Returns how far [m] a point on the line through `at` along the unit vector `axis` moves with the pointer,
// whose ray changes from `from` to `to`; the point is the one of the line nearest to the ray. Returns 0 if
// the line is seen nearly end-on.
double dragged_along(const Pose& from, const Pose& to, const Vec3& at, const Vec3& axis);

// Draws an arrow or a ring with a dark outline, to be visible on every background. `em` is the size of the
// text, `colour` an ImU32.
void draw_handle(const GizmoHandle& handle, double em, uint32_t colour, ImDrawList& list);

// A view along an axis of the world, as in a technical drawing.
struct StandardView {
  const char* name;
  double yaw, pitch;  // of the eye, see Camera::turn_to
};

// In pairs of opposite directions.
inline constexpr double kQuarterTurn = 1.5707963267948966;
inline constexpr std::array kStandardViews{
    StandardView{"Front", 0, 0},
    StandardView{"Back", 2 * kQuarterTurn, 0},
    StandardView{"Right", kQuarterTurn, 0},
    StandardView{"Left", -kQuarterTurn, 0},
    StandardView{"Top", 0, kQuarterTurn},
    StandardView{"Bottom", 0, -kQuarterTurn},
};

// Returns the standard view that the camera shows or moves to, if any.
std::optional<StandardView> standard_view_of(const Camera& camera);

// The axes gizmo in the upper right corner of the first half of the viewport. A click on the end of an axis
// looks from there; a drag orbits. Places are in the window, screen coordinates.

struct AxisEnd {
  StandardView view;  // along the axis, from this end
  int axis = 0;       // 0: X, 1: Y, 2: Z
  bool positive = true;
  Vec2 at{0};
  double depth = 0;  // grows away from the eye, -1 to 1
};

// Returns the six ends, farthest first; none if the viewport is too small.
std::vector<AxisEnd> axis_ends(const ViewState& view);

bool is_on_axes(const ViewState& view, Vec2 at);
// Returns the nearest end of an axis at a place, if any.
std::optional<AxisEnd> axis_end_under(const ViewState& view, Vec2 at);

// Returns the landmark of an end: "axis X", "axis -Y".
std::string name_of(const AxisEnd& end);

// Draws the gizmo with the end under the pointer highlighted, and the kind of view below it.
void draw_axes_gizmo(const ViewState& view, Vec2 pointer, ImDrawList& list);

// Measurements in the first half of the viewport. One with a point behind the eye is not drawn.

// Draws a clicked point [m, world space].
void draw_measured_point(const ViewState& view, const Vec3& point, ImDrawList& list);
// Draws the line between two points with `text` above its middle.
void draw_distance(const ViewState& view, const Vec3& from, const Vec3& to, const std::string& text,
                   ImDrawList& list);

}  // namespace kerf
