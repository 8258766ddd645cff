#pragma once

#include <optional>

#include "ui/gl/objects.h"

namespace kerf::gl {

// A picture in memory of the GPU: colour, and with depth also depth and stencil. The colour is a texture;
// with one sample it is read with linear filtering and clamped at its borders.
class Framebuffer {
 public:
  struct Shape {
    int width = 1, height = 1;
    int samples = 1;    // more than the context offers is taken as what it offers
    bool depth = true;  // 24 bits of depth and 8 of stencil
    GLenum colour = GL_RGBA8;
    friend bool operator==(const Shape&, const Shape&) = default;
  };

  explicit Framebuffer(const Shape& shape);
  // One that has the depth and stencil of another, which is of the same size and samples and outlives it.
  Framebuffer(const Shape& shape, const Framebuffer& depth_of);

  const Shape& shape() const { return shape_; }
  bool complete() const { return complete_; }
  GLuint name() const { return framebuffer_.name(); }
  // A GL_TEXTURE_2D, or GL_TEXTURE_2D_MULTISAMPLE of several samples.
  GLuint colour_texture() const { return colour_.name(); }
  // Makes it what is drawn into, whole.
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

// Copies the colour of all of `from` to `to` (0: the window) with its lower left corner at x, y; resolves
// samples.
void blit(const Framebuffer& from, GLuint to, int x, int y);

}  // namespace kerf::gl
