#pragma once

#include "ui/gl/framebuffer.h"
#include "ui/render/bodies/shaders.h"

namespace kerf {

// Maps the linear light of a scene to the eight bits of the screen, separately for every sample, so that
// edges against bright surfaces stay smooth.
class TonePass {
 public:
  explicit TonePass(Shaders& shaders);

  // Fills the colour of `to` and keeps its depth. Precondition: both have the same size and number of
  // samples.
  void draw(const gl::Framebuffer& scene, const gl::Framebuffer& to) const;

 private:
  gl::Program one_sample_, samples_;
  gl::NoVertices no_vertices_;
};

}  // namespace kerf
