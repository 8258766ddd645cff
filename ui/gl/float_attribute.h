#pragma once

#include <epoxy/gl.h>

#include <cstddef>

namespace kerf::gl {

// Names one attribute of the items of the bound GL_ARRAY_BUFFER to the bound vertex array: so many floats,
// `offset` bytes into each item of `stride` bytes. With divisor 0 an item is a vertex, with 1 an instance.
inline void set_float_attribute(GLuint index, GLint floats, size_t stride, size_t offset,
                                GLuint divisor = 0) {
  glEnableVertexAttribArray(index);
  glVertexAttribPointer(index, floats, GL_FLOAT, GL_FALSE, static_cast<GLsizei>(stride),
                        reinterpret_cast<const void*>(offset));
  glVertexAttribDivisor(index, divisor);
}

}  // namespace kerf::gl
