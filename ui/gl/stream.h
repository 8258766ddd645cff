#pragma once

#include <epoxy/gl.h>

#include <cstddef>
#include <span>
#include <vector>

#include "ui/gl/buffers.h"
#include "ui/gl/objects.h"

namespace kerf::gl {

// Items that are sent anew for each drawing and read as vertices, or as instances.
enum class ItemsAre { kVertices, kInstances };
template <typename Item>
class Stream {
 public:
  // Attributes from 0 on: so many floats each, at these offsets in an item.
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

  // Replaces the items. `usage`: GL_STREAM_DRAW where they are drawn once.
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

}  // namespace kerf::gl
