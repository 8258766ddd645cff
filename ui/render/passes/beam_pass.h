#pragma once

#include <optional>

#include "ui/gl/objects.h"
#include "ui/render/bodies/shaders.h"
#include "ui/render/view/frame_space.h"

namespace kerf {

// A beam to be drawn, in world coordinates (m).
struct BeamPicture {
  Vec3 from, to;
  std::optional<Vec3> strike;  // where it first meets a surface
  double radius = 0.01;        // m
  bool on_ground = false;      // it ends on the ground, at `to`
  double strength = 1;         // of its light: less than 1 for one that is not on yet
};

// The beam with the end that it is seen to have: the ground, a plane at a height (m), if the beam meets it
// before `to`.
BeamPicture ended_on_ground(BeamPicture beam, double ground, UpAxis up = UpAxis::kY);

// Half the side, in pixels, of the square on which the spot of a strike is drawn in a picture of this height,
// for a beam whose radius is `radius_pixels` there. The glow stays visible around a thin beam, but never
// spreads over more than a fifth of the picture's height.
double spot_half_width(double radius_pixels, int height);

// Draws the beam as a bright core with a soft halo that always faces the eye, and a white-hot spot where it
// strikes. The core is as wide as the beam, within limits, and never thinner than a pixel. A beam that does
// not end on the ground fades out over its last metre.
class BeamPass {
 public:
  explicit BeamPass(Shaders& shaders);

  // Sets the uniforms for the light that the spot casts on its environment.
  static void fill_in(FrameUniforms& frame, const FrameSpace& space, const BeamPicture& beam);
  // Adds the beam to a picture of width x height pixels whose opaque surfaces and depth are drawn already,
  // with the near plane at a distance of `near` (m).
  void draw(const CameraView& view, const BeamPicture& beam, const FrameSpace& space, double near, int width,
            int height) const;

 private:
  void draw_ribbon(const CameraView& view, const BeamPicture& beam, double near, int width, int height) const;
  void draw_spot(const CameraView& view, const BeamPicture& beam, const FrameSpace& space, int height) const;

  gl::Program ribbon_, spot_;
  gl::NoVertices no_vertices_;
};

}  // namespace kerf
