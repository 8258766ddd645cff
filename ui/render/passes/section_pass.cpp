#include "ui/render/passes/section_pass.h"

#include <algorithm>

#include "core/base/assert.h"
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
  glEnable(GL_DEPTH_TEST);
  glDepthFunc(GL_EQUAL);
  glDepthMask(GL_FALSE);
  glEnable(GL_BLEND);
  glBlendFuncSeparate(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_ZERO, GL_ONE_MINUS_SRC_ALPHA);
  if (subject.options.cull_backs) glEnable(GL_CULL_FACE);
  line_.use();
  line_.set("wide", scaled_width(kSectionWidth, height));
  for_each_body(subject, [&](BodyId, const Body& body, const BodyPicture& picture) {
    picture.draw(line_, subject.space, body.placement);
  });
  glDisable(GL_CULL_FACE);
  glDisable(GL_BLEND);
  glDepthMask(GL_TRUE);
  glDepthFunc(GL_LESS);
}

}  // namespace kerf
