#pragma once

#include <epoxy/gl.h>
#include <cstddef>
#include <optional>
#include <span>
#include <utility>
#include <vector>

namespace kerf::gl {

// Owns the name of an OpenGL object of the current context. Move-only; must be destroyed before the
// context.
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

// Draws with programs that compute the vertices from gl_VertexID alone.
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

// Binds a buffer and allocates `bytes`: copied from `content`, or undefined if that is null.
inline void fill_buffer(GLenum target, const Buffer& buffer, size_t bytes, const void* content = nullptr,
                        GLenum usage = GL_DYNAMIC_DRAW) {
  glBindBuffer(target, buffer.name());
  glBufferData(target, static_cast<GLsizeiptr>(bytes), content, usage);
}

// Reallocates a buffer to `bytes`: keeps the first `kept` bytes and copies the rest from the same offsets
// of `content`, or leaves it undefined if that is null. Changes the name of the buffer.
inline void enlarge_buffer(Buffer& buffer, size_t kept, size_t bytes, const void* content = nullptr) {
  Buffer larger;
  fill_buffer(GL_COPY_WRITE_BUFFER, larger, bytes, content);
  glBindBuffer(GL_COPY_READ_BUFFER, buffer.name());
  glCopyBufferSubData(GL_COPY_READ_BUFFER, GL_COPY_WRITE_BUFFER, 0, 0, static_cast<GLsizeiptr>(kept));
  buffer = std::move(larger);
}

// Binds a buffer and replaces its items from the index `first` on. Precondition: its size suffices.
template <typename Item>
void put_items(GLenum target, const Buffer& buffer, size_t first, std::span<const Item> items) {
  glBindBuffer(target, buffer.name());
  glBufferSubData(target, static_cast<GLintptr>(first * sizeof(Item)),
                  static_cast<GLsizeiptr>(items.size_bytes()), items.data());
}

// The offset of an attribute in the items of a buffer, with the number and type of its components.
struct Attribute {
  GLint count = 1;
  GLenum type = GL_FLOAT;
  size_t offset = 0;
  bool normalised = false;  // integers are mapped to 0 .. 1 or -1 .. 1
};

// Sets up an attribute of the bound vertex array, a float in the shader, from the bound array buffer with
// items of `size` bytes.
inline void read_floats(GLuint attribute, const Attribute& from, size_t size) {
  glEnableVertexAttribArray(attribute);
  glVertexAttribPointer(attribute, from.count, from.type, from.normalised, static_cast<GLsizei>(size),
                        reinterpret_cast<const void*>(from.offset));
}

// Sets up an attribute that is an integer in the shader.
inline void read_whole(GLuint attribute, const Attribute& from, size_t size) {
  glEnableVertexAttribArray(attribute);
  glVertexAttribIPointer(attribute, from.count, from.type, static_cast<GLsizei>(size),
                         reinterpret_cast<const void*>(from.offset));
}

// Items that are uploaded for each draw call and read as vertices or as instances.
enum class ItemsAre { kVertices, kInstances };
template <typename Item>
class Stream {
 public:
  // Attributes from index 0 on: component count and offset in an item.
  struct Floats {
    GLint count;
    size_t offset;
  };
  Stream(ItemsAre items, const std::vector<Floats>& attributes) {
    glBindVertexArray(layout_.name());
    glBindBuffer(GL_ARRAY_BUFFER, buffer_.name());
    for (GLuint i = 0; i < attributes.size(); ++i) {
      read_floats(i, {attributes[i].count, GL_FLOAT, attributes[i].offset}, sizeof(Item));
      glVertexAttribDivisor(i, items == ItemsAre::kInstances ? 1 : 0);
    }
  }

  // Replaces the items. `usage`: GL_STREAM_DRAW for items that are drawn once.
  void send(std::span<const Item> items, GLenum usage = GL_STREAM_DRAW) {
    bind();
    fill_buffer(GL_ARRAY_BUFFER, buffer_, items.size_bytes(), items.data(), usage);
    count_ = static_cast<GLsizei>(items.size());
  }
  void bind() const { glBindVertexArray(layout_.name()); }
  GLsizei count() const { return count_; }

 private:
  VertexArray layout_;
  Buffer buffer_;
  GLsizei count_ = 0;
};

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
