#pragma once

#include "ui/gl/framebuffer.h"
#include "ui/gl/program.h"

namespace kerf {

// From the linear light of a scene to the eight bits of the screen, for every sample by itself, so that edges
// against what is bright stay smooth.
class TonePass {
 public:
  static Result<TonePass> create(const std::filesystem::path& shaders);

  // Fills the colour of `to`, of the same size and samples, and leaves its depth.
  void draw(const gl::Framebuffer& scene, const gl::Framebuffer& to) const;

 private:
  TonePass(gl::Program one_sample, gl::Program samples);
  gl::Program one_sample_, samples_;
  gl::VertexArray no_vertices_;
};

}  // namespace kerf
