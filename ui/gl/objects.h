#pragma once

#include <epoxy/gl.h>

#include <utility>

namespace kerf::gl {

// Owns the name of an OpenGL object of the current context. Move-only; must be destroyed before the context.
template <typename Kind>
class Object {
 public:
  Object() { Kind::make(&name_); }
  ~Object() { release(); }
  Object(Object&& other) noexcept : name_(std::exchange(other.name_, 0)) {}
  Object& operator=(Object&& other) noexcept {
    if (this != &other) {
      release();
      name_ = std::exchange(other.name_, 0);
    }
    return *this;
  }
  Object(const Object&) = delete;
  Object& operator=(const Object&) = delete;

  GLuint name() const { return name_; }

 private:
  void release() {
    if (name_ != 0) Kind::destroy(name_);
  }
  GLuint name_ = 0;
};

struct BufferKind {
  static void make(GLuint* name) { glGenBuffers(1, name); }
  static void destroy(GLuint name) { glDeleteBuffers(1, &name); }
};

struct VertexArrayKind {
  static void make(GLuint* name) { glGenVertexArrays(1, name); }
  static void destroy(GLuint name) { glDeleteVertexArrays(1, &name); }
};

struct TextureKind {
  static void make(GLuint* name) { glGenTextures(1, name); }
  static void destroy(GLuint name) { glDeleteTextures(1, &name); }
};

struct RenderbufferKind {
  static void make(GLuint* name) { glGenRenderbuffers(1, name); }
  static void destroy(GLuint name) { glDeleteRenderbuffers(1, &name); }
};

struct FramebufferKind {
  static void make(GLuint* name) { glGenFramebuffers(1, name); }
  static void destroy(GLuint name) { glDeleteFramebuffers(1, &name); }
};

using Buffer = Object<BufferKind>;
using VertexArray = Object<VertexArrayKind>;
using Texture = Object<TextureKind>;
using Renderbuffer = Object<RenderbufferKind>;
using FramebufferName = Object<FramebufferKind>;

// Draws with programs that compute the corners from gl_VertexID alone.
class NoVertices {
 public:
  void draw(GLenum mode, GLsizei count) const {
    glBindVertexArray(layout_.name());
    glDrawArrays(mode, 0, count);
  }
  // Draws the triangle of screen.vert, which covers the viewport.
  void draw_screen() const { draw(GL_TRIANGLES, 3); }

 private:
  VertexArray layout_;
};

}  // namespace kerf::gl
