#include "ui/render/passes/post_processing.h"

#include <algorithm>
#include <array>

#include "core/base/assert.h"
#include "ui/gl/program.h"

namespace kerf {

TonePass::TonePass(Shaders& shaders)
    : one_sample_(shaders.load({{"screen.vert"}, {"frame.glsl", "light.glsl", "tone.frag"}})),
      samples_(shaders.load({{"screen.vert"}, {"frame.glsl", "light.glsl", "tone.frag"}, {"SAMPLES"}})) {}

void TonePass::draw(const gl::Framebuffer& scene, const gl::Framebuffer& to) const {
  KERF_ASSERT(scene.shape().width == to.shape().width && scene.shape().height == to.shape().height &&
              scene.shape().samples == to.shape().samples);
  const int count = scene.shape().samples;
  const gl::Program& program = count > 1 ? samples_ : one_sample_;
  to.bind();
  const gl::ScopedState state({.depth = GL_NONE});
  program.use();
  const GLenum kind = count > 1 ? GL_TEXTURE_2D_MULTISAMPLE : GL_TEXTURE_2D;
  program.set_texture("scene", 0, scene.colour_texture(), kind);
  if (count > 1) glEnable(GL_SAMPLE_MASK);
  for (int i = 0; i < count; ++i) {
    if (count > 1) glSampleMaski(0, 1u << i);
    program.set("which", i);
    no_vertices_.draw_screen();
  }
  if (count > 1) {
    glSampleMaski(0, ~0u);
    glDisable(GL_SAMPLE_MASK);
  }
}

namespace {

glm::vec4 pixel_of(const gl::Framebuffer& picture) {
  return {1.0f / static_cast<float>(picture.shape().width), 1.0f / static_cast<float>(picture.shape().height),
          0, 0};
}

// A rotated grid: no two frames share a row or a column of their sub-pixels.
constexpr std::array<glm::vec2, GatheredPicture::kPictures> kShifts{
    glm::vec2(-0.125f, -0.375f), glm::vec2(0.375f, -0.125f), glm::vec2(0.125f, 0.375f),
    glm::vec2(-0.375f, 0.125f)};

}  // namespace

BloomPass::BloomPass(Shaders& shaders)
    : bright_(shaders.load({{"screen.vert"}, {"bright.frag"}})),
      blur_(shaders.load({{"screen.vert"}, {"blur.frag"}})),
      lay_over_(shaders.load({{"glow.vert"}, {"bloom.frag"}})) {}

BloomPass::Level::Level(int width, int height)
    : glow({std::max(1, width), std::max(1, height), 1, false}), half_way(glow.shape()) {}

// Downscales `from` into level.glow and blurs the result. With a size, takes only bright pixels of that
// frame; without one (0), `from` is the glow of a level.
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

  // Most of a frame does not glow and is copied unchanged.
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

GatheredPicture::GatheredPicture(Shaders& shaders) : copy_(shaders.load({{"screen.vert"}, {"share.frag"}})) {}

void GatheredPicture::begin(int width, int height) {
  KERF_ASSERT(width > 0 && height > 0);
  const gl::Framebuffer::Shape next{width, height, 1, false}, sum{width, height, 1, false, GL_RGBA16F};
  if (!next_ || !(next_->shape() == next)) next_.emplace(next);
  if (!sum_ || !(sum_->shape() == sum)) sum_.emplace(sum);
  sum_->bind();
  glClearColor(0, 0, 0, 0);
  glClear(GL_COLOR_BUFFER_BIT);
  count_ = 0;
}

bool GatheredPicture::can_show(const Target& target) const {
  return sum_ && count_ > 0 && sum_->shape().width == target.width && sum_->shape().height == target.height;
}

void GatheredPicture::add(const std::function<void(const Target&)>& draw) {
  KERF_ASSERT(sum_.has_value());
  const auto [width, height] = std::pair(next_->shape().width, next_->shape().height);
  draw({next_->name(), 0, 0, width, height, kShifts[static_cast<size_t>(count_ % kPictures)]});
  sum_->bind();
  const float kept = complete() ? 1 - 1.0f / kPictures : 1;
  glBlendColor(kept, kept, kept, kept);
  const gl::ScopedState state(
      {.depth = GL_NONE, .blend = gl::Blend{GL_ONE, GL_CONSTANT_COLOR, GL_ONE, GL_CONSTANT_COLOR}});
  copy(*next_, 1.0f / kPictures, {0, 0});
  ++count_;
}

void GatheredPicture::show(const Target& target) const {
  KERF_ASSERT(can_show(target));
  glBindFramebuffer(GL_FRAMEBUFFER, target.framebuffer);
  glViewport(target.x, target.y, target.width, target.height);
  const gl::ScopedState state({.depth = GL_NONE});
  copy(*sum_, static_cast<float>(kPictures) / static_cast<float>(std::min(count_, kPictures)),
       {target.x, target.y});
}

void GatheredPicture::forget() {
  next_.reset();
  sum_.reset();
  count_ = 0;
}

void GatheredPicture::copy(const gl::Framebuffer& from, float share, const glm::ivec2& at) const {
  glDisable(GL_SCISSOR_TEST);
  copy_.use();
  copy_.set_texture("picture", 0, from.colour_texture());
  copy_.set("place", glm::vec4(at, share, 0));
  no_vertices_.draw_screen();
}

}  // namespace kerf
