#pragma once

#include <optional>

#include "ui/gl/objects.h"
#include "ui/gl/program.h"
#include "ui/render/frame_space.h"

namespace kerf {

// A beam as it is drawn, in world coordinates.
struct BeamPicture {
  Vec3 from, to;
  std::optional<Vec3> strike;  // where it meets the first surface
  double radius = 0.01;        // m
};

// The beam: a thin core in a soft halo that always faces the eye, and a white-hot spot where it strikes.
class BeamPass {
 public:
  static Result<BeamPass> create(const std::filesystem::path& shaders);

  // The light of the spot on its surroundings.
  static void fill_in(FrameUniforms& frame, const FrameSpace& space, const BeamPicture& beam);
  // After everything opaque, with the depth of it; adds light.
  void draw(const CameraView& view, const FrameSpace& space, const BeamPicture& beam, int height) const;

 private:
  BeamPass(gl::Program ribbon, gl::Program spot);
  gl::Program ribbon_, spot_;
  gl::VertexArray no_vertices_;
};

}  // namespace kerf
