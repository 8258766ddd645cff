#pragma once

#include <optional>

#include "ui/render/view/camera.h"

namespace kerf {

// A straight segment as a picture shows it.
struct ScreenSegment {
  Vec2 from, to;       // its ends in pixels, from the lower left corner of the picture
  Vec2 inverse_depth;  // 1 / m along the view's axis, at both ends; linear between them in the picture. In an
                       // orthographic view both are that of the focus, for it shows all lengths as large
  Vec2 share;          // of the whole segment that lies before either end, 0 to 1
};

// What is left of the segment between two points of the world (m) after it was clipped, in double precision,
// against the plane of the eye and against the sides of the picture moved outward by `margin` pixels. Method:
// Liang and Barsky, A new concept and method for line clipping, 1984, in homogeneous coordinates. Empty where
// nothing is left. The picture is width x height pixels, both positive.
std::optional<ScreenSegment> on_screen(const CameraView& view, const Vec3& from, const Vec3& to, int width,
                                       int height, double margin);

}  // namespace kerf
