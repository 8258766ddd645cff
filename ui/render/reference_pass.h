#pragma once

#include "ui/gl/framebuffer.h"
#include "ui/gl/program.h"
#include "ui/render/shadow_reference.h"

namespace kerf {

// Shadows by rays over a picture: dark where the light is kept away, pale where it arrives, magenta where the
// picture, counted with one sample, has it the other way round. Rows that are not traced yet stay as they
// are.
class ReferencePass {
 public:
  static Result<ReferencePass> create(const std::filesystem::path& shaders);

  // Over what is bound, whole.
  void draw(const ShadowReference& traced, const ShadowCounts& drawn) const;

 private:
  explicit ReferencePass(gl::Program overlay) : overlay_(std::move(overlay)) {}
  gl::Program overlay_;
  gl::Texture picture_;
  gl::VertexArray no_vertices_;
};

}  // namespace kerf
