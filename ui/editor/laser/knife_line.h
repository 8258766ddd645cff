#pragma once

#include "core/cut/knife.h"
#include "core/world/world.h"
#include "ui/render/view/camera.h"

namespace kerf {

// Returns the plane through a line in the frame (coordinates as in CameraView::ray): it contains the rays
// through both points, so it passes through the eye or, in an orthographic view, lies along the view
// direction. The normal is a unit vector. Precondition: the points differ by far more than rounding.
KnifePlane plane_through(const CameraView& view, Vec2 from, Vec2 to);

// Returns true if a visible body has vertices on both sides of a plane. O(faces).
bool crosses(const World& world, const KnifePlane& plane);

}  // namespace kerf
