#pragma once

#include <optional>

#include "ui/gl/framebuffer.h"
#include "ui/gl/program.h"

namespace kerf {

// The glow around what is bright: what the alpha of a picture marks as shining is blurred in a quarter and in
// a sixteenth of its size and laid over it.
class BloomPass {
 public:
  static Result<BloomPass> create(const std::filesystem::path& shaders);

  // Draws `picture` (one sample) with its glow into a framebuffer, its lower left corner at x, y.
  void draw(const gl::Framebuffer& picture, GLuint target, int x, int y);

 private:
  BloomPass(gl::Program bright, gl::Program blur, gl::Program lay_over);
  struct Level {
    gl::Framebuffer glow, half_way;
    Level(int width, int height);
  };
  void fill(Level& level, GLuint from, int width, int height);

  gl::Program bright_, blur_, lay_over_;
  gl::VertexArray no_vertices_;
  std::optional<Level> near_, far_;
};

}  // namespace kerf
