#pragma once

#include <optional>

#include "ui/gl/framebuffer.h"
#include "ui/render/bodies/shaders.h"

namespace kerf {

// Draws the glow around bright pixels: those that the alpha channel of a picture marks are blurred at a
// quarter and at a sixteenth of its resolution and added to it.
class BloomPass {
 public:
  explicit BloomPass(Shaders& shaders);

  // Draws `picture`, which has one sample per pixel, with its glow into the framebuffer `target` at x, y.
  void draw(const gl::Framebuffer& picture, GLuint target, int x, int y);

 private:
  struct Level {
    gl::Framebuffer glow, half_way;
    Level(int width, int height);
  };
  void fill(Level& level, GLuint from, int width, int height);

  gl::Program bright_, blur_, lay_over_;
  gl::NoVertices no_vertices_;
  std::optional<Level> near_, far_;
};

}  // namespace kerf
