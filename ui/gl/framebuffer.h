#pragma once

#include <optional>

#include "ui/gl/buffers.h"

namespace kerf::gl {

// An off-screen framebuffer with a colour texture and optionally depth and stencil. A texture with one
// sample per pixel has linear filtering and is clamped at its borders.
class Framebuffer {
 public:
  struct Shape {
    int width = 1, height = 1;
    int samples = 1;    // limited to the maximum of the context
    bool depth = true;  // 24 bits of depth and 8 of stencil
    GLenum colour = GL_RGBA8;
    friend bool operator==(const Shape&, const Shape&) = default;
  };

  explicit Framebuffer(const Shape& shape);
  // Shares the depth and stencil of `depth_of`, and uses its number of samples. Precondition: `depth_of`
  // has its own depth buffer and the same size, and outlives this object.
  Framebuffer(const Shape& shape, const Framebuffer& depth_of);

  const Shape& shape() const { return shape_; }
  bool complete() const { return complete_; }
  GLuint name() const { return framebuffer_.name(); }
  // A GL_TEXTURE_2D, or with several samples a GL_TEXTURE_2D_MULTISAMPLE.
  GLuint colour_texture() const { return colour_.name(); }
  // Binds it for drawing, with a viewport of its whole size.
  void bind() const;

 private:
  void add_colour();
  void add_depth(GLuint renderbuffer);

  Shape shape_;
  bool complete_ = false;
  FramebufferName framebuffer_;
  Texture colour_;
  std::optional<Renderbuffer> depth_;
};

// Copies the colour of `from` into `to` (0: the window) at the lower left corner x, y, and resolves
// samples. Precondition: `to` is another framebuffer.
void blit(const Framebuffer& from, GLuint to, int x, int y);

}  // namespace kerf::gl
