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

}  // namespace

BloomPass::BloomPass(Shaders& shaders)
    : bright_(shaders.load({{"screen.vert"}, {"bright.frag"}})),
      blur_(shaders.load({{"screen.vert"}, {"blur.frag"}})),
      lay_over_(shaders.load({{"glow.vert"}, {"bloom.frag"}})) {}

BloomPass::Level::Level(int width, int height)
    : glow({std::max(1, width), std::max(1, height), 1, false}), half_way(glow.shape()) {}

// Shrinks the picture `from` into level.glow and blurs the result. Only bright pixels of a picture with a
// size are taken; without a size (0) `from` is the glow of a level.
void BloomPass::fill(Level& level, GLuint from, int width, int height) {
  const auto draw = [&](const gl::Program& program, GLuint picture, const glm::vec4& stride,
                        const gl::Framebuffer& to) {
    to.bind();
    program.use();
    program.set_texture("picture", 0, picture);
    program.set("stride", stride);
    no_vertices_.draw_screen();
  };
  const glm::vec4 pixel = pixel_of(level.glow);
  if (width > 0) {
    draw(bright_, from, {1.0f / static_cast<float>(width), 1.0f / static_cast<float>(height), 0, 0},
         level.glow);
  } else {
    draw(blur_, from, glm::vec4(0), level.glow);
  }
  draw(blur_, level.glow.colour_texture(), {pixel.x, 0, 0, 0}, level.half_way);
  draw(blur_, level.half_way.colour_texture(), {0, pixel.y, 0, 0}, level.glow);
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
  fill(*near_, picture.colour_texture(), w, h);
  fill(*far_, near_->glow.colour_texture(), 0, 0);

  // Most of a picture does not shine and is handed over as it is.
  gl::blit(picture, target, x, y);
  glBindFramebuffer(GL_FRAMEBUFFER, target);
  glViewport(x, y, w, h);
  lay_over_.use();
  lay_over_.set_texture("picture", 0, picture.colour_texture());
  lay_over_.set_texture("near_glow", 1, near_->glow.colour_texture());
  lay_over_.set_texture("far_glow", 2, far_->glow.colour_texture());
  const gl::Framebuffer::Shape& tiles = far_->glow.shape();
  no_vertices_.draw(GL_TRIANGLES, 6 * tiles.width * tiles.height);
}

}  // namespace kerf
