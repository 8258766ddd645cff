#include "ui/render/shadow/reference_pass.h"

#include <array>

#include "core/base/assert.h"
#include "ui/gl/state.h"
#include "ui/render/view/overlay_colours.h"

namespace kerf {

namespace {

using Pixel = std::array<uint8_t, 4>;
constexpr Pixel pixel_of(uint32_t hex, uint8_t opacity) {
  return {static_cast<uint8_t>(hex >> 16 & 0xffu), static_cast<uint8_t>(hex >> 8 & 0xffu),
          static_cast<uint8_t>(hex & 0xffu), opacity};
}
constexpr Pixel kClear{0, 0, 0, 0}, kLitPixel = pixel_of(overlay_colours::kTracedLit, 80),
                                    kShadow = pixel_of(overlay_colours::kTracedShadow, 190),
                                    kWrong = pixel_of(overlay_colours::kWrong, 255);

Pixel colour(const ShadowReference& traced, const ShadowCounts& drawn, size_t i) {
  if (traced.faces()[i] == 0) return kClear;
  const bool shadow = traced.occluders()[i] > 0;
  const bool wrong = traced.faces()[i] == drawn.faces[i] && shadow != (drawn.stencil[i] != 0);
  return wrong ? kWrong : shadow ? kShadow : kLitPixel;
}

}  // namespace

ReferencePass::ReferencePass(Shaders& shaders)
    : overlay_(shaders.load({{"screen.vert"}, {"overlay.frag"}})) {}

void ReferencePass::draw(const ShadowReference& traced, const ShadowCounts& drawn) const {
  KERF_ASSERT(drawn.width == traced.width() && drawn.height == traced.height());
  std::vector<Pixel> pixels(traced.faces().size());
  for (size_t i = 0; i < pixels.size(); ++i) pixels[i] = colour(traced, drawn, i);
  glActiveTexture(GL_TEXTURE0);
  glBindTexture(GL_TEXTURE_2D, picture_.name());
  glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, traced.width(), traced.height(), 0, GL_RGBA, GL_UNSIGNED_BYTE,
               pixels.data());
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
  const gl::ScopedState state({.depth = GL_NONE, .blend = gl::kOver});
  overlay_.use();
  overlay_.set("picture", 0);
  no_vertices_.draw_screen();
}

}  // namespace kerf
