#pragma once

#include <optional>
#include <span>
#include <vector>

#include "core/cut/knife.h"
#include "core/world/world.h"
#include "ui/render/view/camera.h"

namespace kerf {

// Shape of the cuts that the Knife tool draws.
enum class KnifeShape { kLine, kLasso, kPolyline };

// Returns the plane through a line in the frame (coordinates as in CameraView::ray): it contains the rays
// through both points, so it passes through the eye or, in an orthographic view, lies along the view
// direction. The normal is a unit vector. Precondition: the points differ by far more than rounding.
KnifePlane plane_through(const CameraView& view, Vec2 from, Vec2 to);

// Returns true if a visible body has vertices on both sides of a plane. O(faces).
bool crosses(const World& world, const KnifePlane& plane);

// Returns the points of a curve without those that are closer than `tolerance` to the rest, in the unit of
// the points: its ends, or, if it is closed, its first point and the one farthest from that, and the points
// between them that matter. Method: Douglas and Peucker, Algorithms for the reduction of the number of points
// required to represent a digitized line or its caricature, 1973. O(n log n) for usual curves.
std::vector<Vec2> simplified(std::span<const Vec2> points, double tolerance, bool closed);

// Returns a part of a closed curve that does not cross itself: at each crossing, the loop of the larger area.
// Empty if no area is left. O(n^2) per crossing.
std::vector<Vec2> largest_loop(std::vector<Vec2> points);

// Returns true if a segment from the last point of a polyline to `to` crosses the polyline or turns back on
// it.
bool would_cross(std::span<const Vec2> line, Vec2 to);

// Returns the surface that the rays through a curve of the frame (see plane_through()) sweep through these
// bounds: a cone from the eye, or a prism in an orthographic view. Successive points must differ by far more
// than rounding. Precondition: at least two points, three if it is closed.
KnifePath path_along_view(const CameraView& view, std::span<const Vec2> points, bool closed,
                          const Bounds& bounds);

}  // namespace kerf
