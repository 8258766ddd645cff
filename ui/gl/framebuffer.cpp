#include "ui/gl/framebuffer.h"

#include <algorithm>

namespace kerf::gl {

namespace {

int offered_samples(int wanted) {
  GLint most = 1;
  glGetIntegerv(GL_MAX_SAMPLES, &most);
  return std::clamp(wanted, 1, std::max(1, static_cast<int>(most)));
}

void allocate(const Renderbuffer& buffer, GLenum format, const Framebuffer::Shape& shape) {
  glBindRenderbuffer(GL_RENDERBUFFER, buffer.name());
  glRenderbufferStorageMultisample(GL_RENDERBUFFER, shape.samples > 1 ? shape.samples : 0, format,
                                   shape.width, shape.height);
}

void allocate(const Texture& texture, const Framebuffer::Shape& shape) {
  glBindTexture(GL_TEXTURE_2D, texture.name());
  const GLenum type = shape.colour == GL_RGBA8 ? GL_UNSIGNED_BYTE : GL_FLOAT;
  glTexImage2D(GL_TEXTURE_2D, 0, static_cast<GLint>(shape.colour), shape.width, shape.height, 0, GL_RGBA,
               type, nullptr);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
}

}  // namespace

Framebuffer::Framebuffer(const Shape& shape) : shape_(shape) {
  shape_.samples = offered_samples(shape.samples);
  glBindFramebuffer(GL_FRAMEBUFFER, framebuffer_.name());
  if (shape_.samples > 1) {
    allocate(colour_.emplace(), shape_.colour, shape_);
    glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER, colour_->name());
  } else {
    allocate(texture_.emplace(), shape_);
    glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, texture_->name(), 0);
  }
  if (shape_.depth) {
    allocate(depth_.emplace(), GL_DEPTH24_STENCIL8, shape_);
    glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_DEPTH_STENCIL_ATTACHMENT, GL_RENDERBUFFER, depth_->name());
  }
  complete_ = glCheckFramebufferStatus(GL_FRAMEBUFFER) == GL_FRAMEBUFFER_COMPLETE;
}

void Framebuffer::bind() const {
  glBindFramebuffer(GL_FRAMEBUFFER, framebuffer_.name());
  glViewport(0, 0, shape_.width, shape_.height);
}

void blit(const Framebuffer& from, GLuint to, int x, int y) {
  const int w = from.shape().width, h = from.shape().height;
  glBindFramebuffer(GL_READ_FRAMEBUFFER, from.name());
  glBindFramebuffer(GL_DRAW_FRAMEBUFFER, to);
  glBlitFramebuffer(0, 0, w, h, x, y, x + w, y + h, GL_COLOR_BUFFER_BIT, GL_NEAREST);
}

}  // namespace kerf::gl
