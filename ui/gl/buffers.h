#pragma once

#include <epoxy/gl.h>

#include <cstddef>
#include <span>
#include <utility>

#include "ui/gl/objects.h"

namespace kerf::gl {

// Binds a buffer and gives it so many bytes: those at `content`, or undefined ones if that is null.
inline void fill_buffer(GLenum target, const Buffer& buffer, size_t bytes, const void* content = nullptr,
                        GLenum usage = GL_DYNAMIC_DRAW) {
  glBindBuffer(target, buffer.name());
  glBufferData(target, static_cast<GLsizeiptr>(bytes), content, usage);
}

// Gives a buffer so many bytes: the first `kept` ones stay what they were, the others are those at `content`
// there, or undefined ones if that is null. The buffer has another name then.
inline void enlarge_buffer(Buffer& buffer, size_t kept, size_t bytes, const void* content = nullptr) {
  Buffer larger;
  fill_buffer(GL_COPY_WRITE_BUFFER, larger, bytes, content);
  glBindBuffer(GL_COPY_READ_BUFFER, buffer.name());
  glCopyBufferSubData(GL_COPY_READ_BUFFER, GL_COPY_WRITE_BUFFER, 0, 0, static_cast<GLsizeiptr>(kept));
  buffer = std::move(larger);
}

// Binds a buffer and replaces its items from the index `first` on. Precondition: it has room for them.
template <typename Item>
void put_items(GLenum target, const Buffer& buffer, size_t first, std::span<const Item> items) {
  glBindBuffer(target, buffer.name());
  glBufferSubData(target, static_cast<GLintptr>(first * sizeof(Item)),
                  static_cast<GLsizeiptr>(items.size_bytes()), items.data());
}

// Where an attribute lies in the items of a buffer, and how many numbers of which type it has.
struct Attribute {
  GLint count = 1;
  GLenum type = GL_FLOAT;
  size_t offset = 0;
  bool normalised = false;  // whole numbers stand for 0 .. 1 or -1 .. 1
};

// Reads an attribute of the bound vertex array, which is a float in the shader, from the bound array buffer
// with items of `size` bytes.
inline void read_floats(GLuint attribute, const Attribute& from, size_t size) {
  glEnableVertexAttribArray(attribute);
  glVertexAttribPointer(attribute, from.count, from.type, from.normalised, static_cast<GLsizei>(size),
                        reinterpret_cast<const void*>(from.offset));
}

// Reads an attribute that is a whole number in the shader.
inline void read_whole(GLuint attribute, const Attribute& from, size_t size) {
  glEnableVertexAttribArray(attribute);
  glVertexAttribIPointer(attribute, from.count, from.type, static_cast<GLsizei>(size),
                         reinterpret_cast<const void*>(from.offset));
}

}  // namespace kerf::gl
