#include "ui/render/passes/gathered_picture.h"

#include <algorithm>
#include <array>

#include "core/base/assert.h"
#include "ui/gl/state.h"

namespace kerf {

namespace {

// A rotated grid: no two pictures share a row or a column of their sub-pixels.
constexpr std::array<glm::vec2, GatheredPicture::kPictures> kShifts{
    glm::vec2(-0.125f, -0.375f), glm::vec2(0.375f, -0.125f), glm::vec2(0.125f, 0.375f),
    glm::vec2(-0.375f, 0.125f)};

}  // namespace

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
