#include "ui/gl/buffers.h"

#include <algorithm>

#include "core/base/assert.h"

namespace kerf::gl {

namespace {

int offered_samples(int wanted) {
  GLint most = 1;
  glGetIntegerv(GL_MAX_SAMPLES, &most);
  return std::clamp(wanted, 1, std::max(1, static_cast<int>(most)));
}

}  // namespace

Framebuffer::Framebuffer(const Shape& shape) : shape_(shape) {
  shape_.samples = offered_samples(shape.samples);
  add_colour();
  if (shape_.depth) {
    glBindRenderbuffer(GL_RENDERBUFFER, depth_.emplace().name());
    glRenderbufferStorageMultisample(GL_RENDERBUFFER, shape_.samples > 1 ? shape_.samples : 0,
                                     GL_DEPTH24_STENCIL8, shape_.width, shape_.height);
    add_depth(depth_->name());
  }
  complete_ = glCheckFramebufferStatus(GL_FRAMEBUFFER) == GL_FRAMEBUFFER_COMPLETE;
}

Framebuffer::Framebuffer(const Shape& shape, const Framebuffer& depth_of) : shape_(shape) {
  KERF_ASSERT(depth_of.depth_ && shape.width == depth_of.shape().width &&
              shape.height == depth_of.shape().height);
  shape_.samples = depth_of.shape().samples;
  add_colour();
  add_depth(depth_of.depth_->name());
  complete_ = glCheckFramebufferStatus(GL_FRAMEBUFFER) == GL_FRAMEBUFFER_COMPLETE;
}

void Framebuffer::add_colour() {
  const bool several = shape_.samples > 1;
  const GLenum kind = several ? GL_TEXTURE_2D_MULTISAMPLE : GL_TEXTURE_2D;
  glBindFramebuffer(GL_FRAMEBUFFER, framebuffer_.name());
  glBindTexture(kind, colour_.name());
  if (several) {
    glTexImage2DMultisample(kind, shape_.samples, shape_.colour, shape_.width, shape_.height, GL_TRUE);
  } else {
    const GLenum type = shape_.colour == GL_RGBA8 ? GL_UNSIGNED_BYTE : GL_FLOAT;
    glTexImage2D(kind, 0, static_cast<GLint>(shape_.colour), shape_.width, shape_.height, 0, GL_RGBA, type,
                 nullptr);
    glTexParameteri(kind, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
    glTexParameteri(kind, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
    glTexParameteri(kind, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
    glTexParameteri(kind, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
  }
  glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, kind, colour_.name(), 0);
}

void Framebuffer::add_depth(GLuint renderbuffer) {
  glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_DEPTH_STENCIL_ATTACHMENT, GL_RENDERBUFFER, renderbuffer);
}

void Framebuffer::bind() const {
  glBindFramebuffer(GL_FRAMEBUFFER, framebuffer_.name());
  glViewport(0, 0, shape_.width, shape_.height);
}

void blit(const Framebuffer& from, GLuint to, int x, int y) {
  KERF_ASSERT(to != from.name());
  const int w = from.shape().width, h = from.shape().height;
  glBindFramebuffer(GL_READ_FRAMEBUFFER, from.name());
  glBindFramebuffer(GL_DRAW_FRAMEBUFFER, to);
  glBlitFramebuffer(0, 0, w, h, x, y, x + w, y + h, GL_COLOR_BUFFER_BIT, GL_NEAREST);
}

}  // namespace kerf::gl
