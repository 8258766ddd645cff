#include "ui/render/shadow/shadow_probe.h"

#include "core/base/assert.h"
#include "ui/render/passes/marked_faces.h"

namespace kerf {

ShadowProbe::ShadowProbe(Shaders& shaders)
    : faces_(shaders.load({{"frame.glsl", "placed.glsl", "faces.vert"}, {"mark.frag"}})),
      ground_(shaders.load({{"frame.glsl", "ground.vert"}, {"solid.frag"}})) {}

void ShadowProbe::draw_marks(const Subject& subject, const GroundPass* ground) const {
  draw_marked_faces(subject, faces_);
  if (ground == nullptr) return;
  ground_.use();
  ground_.set("colour", glm::vec4(0, 0, 0, 1));
  ground->draw_disc(subject.space);
}

ShadowCounts ShadowProbe::look(const Subject& subject, ShadowPass& shadows, size_t light, ShadowMethod method,
                               const GroundPass* ground, int width, int height) {
  KERF_ASSERT(is_frame_bound());
  KERF_ASSERT(width > 0 && height > 0);
  const gl::Framebuffer::Shape shape{width, height, 1, true};
  if (!picture_ || !(picture_->shape() == shape)) picture_.emplace(shape);
  picture_->bind();
  draw_marks(subject, ground);
  shadows.count(subject, light, method, ground ? ground->hidden_below(subject.space) : std::nullopt);
  const size_t pixels = static_cast<size_t>(width) * static_cast<size_t>(height);
  ShadowCounts counts{width, height, std::vector<uint32_t>(pixels), std::vector<uint8_t>(pixels)};
  std::vector<uint8_t> marks(4 * pixels);
  glPixelStorei(GL_PACK_ALIGNMENT, 1);
  glReadPixels(0, 0, width, height, GL_RGBA, GL_UNSIGNED_BYTE, marks.data());
  glReadPixels(0, 0, width, height, GL_STENCIL_INDEX, GL_UNSIGNED_BYTE, counts.stencil.data());
  glPixelStorei(GL_PACK_ALIGNMENT, 4);
  for (size_t i = 0; i < pixels; ++i) {
    counts.faces[i] = marks[4 * i] | uint32_t{marks[4 * i + 1]} << 8 | uint32_t{marks[4 * i + 2]} << 16 |
                      uint32_t{marks[4 * i + 3]} << 24;
  }
  return counts;
}

size_t differing_pixels(const ShadowCounts& a, const ShadowCounts& b) {
  KERF_ASSERT(a.width == b.width && a.height == b.height);
  size_t off = 0;
  for (size_t i = 0; i < a.stencil.size(); ++i) {
    off += a.faces[i] != 0 && (a.stencil[i] == 0) != (b.stencil[i] == 0);
  }
  return off;
}

}  // namespace kerf
