#pragma once

#include <cmath>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "ui/editor/shared/picture/first_picture.h"
#include "ui/window/landmarks.h"

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

}  // namespace kerf
