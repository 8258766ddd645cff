#include "ui/render/passes/bloom_pass.h"

#include <algorithm>

#include "core/base/assert.h"
#include "ui/gl/state.h"

namespace kerf {

namespace {

glm::vec4 pixel_of(const gl::Framebuffer& picture) {
  return {1.0f / static_cast<float>(picture.shape().width), 1.0f / static_cast<float>(picture.shape().height),
          0, 0};
}

void bind_texture(int unit, GLuint texture) {
  glActiveTexture(static_cast<GLenum>(GL_TEXTURE0 + unit));
  glBindTexture(GL_TEXTURE_2D, texture);
}

void draw_screen() { glDrawArrays(GL_TRIANGLES, 0, 3); }

}  // namespace

BloomPass::BloomPass(Shaders& shaders)
    : bright_(shaders.load({{"screen.vert"}, {"bright.frag"}})),
      blur_(shaders.load({{"screen.vert"}, {"blur.frag"}})),
      lay_over_(shaders.load({{"glow.vert"}, {"bloom.frag"}})) {}

BloomPass::Level::Level(int width, int height)
    : glow({std::max(1, width), std::max(1, height), 1, false}), half_way(glow.shape()) {}

// What is in level.glow is blurred; before, `from` is shrunk into it where it is another picture.
void BloomPass::fill(Level& level, GLuint from, int width, int height) {
  const glm::vec4 pixel = pixel_of(level.glow);
  bind_texture(0, from);
  level.glow.bind();
  if (width > 0) {
    bright_.use();
    bright_.set("picture", 0);
    bright_.set("stride",
                glm::vec4(1.0f / static_cast<float>(width), 1.0f / static_cast<float>(height), 0, 0));
  } else {
    blur_.use();
    blur_.set("picture", 0);
    blur_.set("stride", glm::vec4(0));
  }
  draw_screen();
  blur_.use();
  blur_.set("picture", 0);
  level.half_way.bind();
  bind_texture(0, level.glow.colour_texture());
  blur_.set("stride", glm::vec4(pixel.x, 0, 0, 0));
  draw_screen();
  level.glow.bind();
  bind_texture(0, level.half_way.colour_texture());
  blur_.set("stride", glm::vec4(0, pixel.y, 0, 0));
  draw_screen();
}

void BloomPass::draw(const gl::Framebuffer& picture, GLuint target, int x, int y) {
  KERF_ASSERT(picture.shape().samples == 1);
  const int w = picture.shape().width, h = picture.shape().height;
  const gl::Framebuffer::Shape quarter{std::max(1, w / 4), std::max(1, h / 4), 1, false};
  if (!near_ || !(near_->glow.shape() == quarter)) {
    near_.emplace(w / 4, h / 4);
    far_.emplace(w / 16, h / 16);
  }
  const gl::ScopedState state({.depth = GL_NONE});
  glBindVertexArray(no_vertices_.name());
  fill(*near_, picture.colour_texture(), w, h);
  fill(*far_, near_->glow.colour_texture(), 0, 0);

  // Most of a picture does not shine and is handed over as it is.
  gl::blit(picture, target, x, y);
  glBindFramebuffer(GL_FRAMEBUFFER, target);
  glViewport(x, y, w, h);
  lay_over_.use();
  bind_texture(0, picture.colour_texture());
  bind_texture(1, near_->glow.colour_texture());
  bind_texture(2, far_->glow.colour_texture());
  lay_over_.set("picture", 0);
  lay_over_.set("near_glow", 1);
  lay_over_.set("far_glow", 2);
  const gl::Framebuffer::Shape& tiles = far_->glow.shape();
  glDrawArrays(GL_TRIANGLES, 0, 6 * tiles.width * tiles.height);
  glActiveTexture(GL_TEXTURE0);
}

}  // namespace kerf
