#include "ui/render/passes/section_pass.h"

#include "core/base/assert.h"
#include "ui/gl/state.h"
#include "ui/render/view/scaled_width.h"
#include "ui/render/view/section_clip.h"

namespace kerf {

namespace {

constexpr float kSectionWidth = 1.5f;  // see scaled_width

}  // namespace

SectionPass::SectionPass(Shaders& shaders)
    : line_(shaders.load({{"frame.glsl", "placed.glsl", "section.vert"}, {"section.frag"}})) {}

void SectionPass::draw(const Subject& subject, int height) const {
  if (shown_section(subject.options) == nullptr) return;
  KERF_ASSERT(is_frame_bound());
  const SectionClip clip(subject.options);
  const gl::ScopedState state(
      {.depth = GL_EQUAL, .writes_depth = false, .culled = subject.culled(), .blend = gl::kOver});
  line_.use();
  line_.set("wide", scaled_width(kSectionWidth, height));
  draw_bodies(subject, line_);
}

}  // namespace kerf
