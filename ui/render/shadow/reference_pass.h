#pragma once

#include "ui/gl/framebuffer.h"
#include "ui/render/bodies/shaders.h"
#include "ui/render/shadow/shadow_reference.h"

namespace kerf {

// Draws ray-traced shadows over a picture: dark where the light is occluded, pale where it is not, and
// magenta where the shadow volumes, counted with one sample per pixel, disagree. Rows that are not traced yet
// stay unchanged.
class ReferencePass {
 public:
  explicit ReferencePass(Shaders& shaders);

  // Draws over the whole bound framebuffer. Precondition: both are of pictures of the same size.
  void draw(const ShadowReference& traced, const ShadowCounts& drawn) const;

 private:
  gl::Program overlay_;
  gl::Texture picture_;
  gl::NoVertices no_vertices_;
};

}  // namespace kerf
