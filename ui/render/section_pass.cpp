#include "ui/render/section_pass.h"

#include <algorithm>

#include "ui/render/section_clip.h"

namespace kerf {

namespace {

constexpr float kWide = 1.5f;          // pixels, in a picture
constexpr float kPictureHeight = 900;  // of this height or less

}  // namespace

Result<SectionPass> SectionPass::create(const std::filesystem::path& shaders) {
  auto line = gl::Program::load(shaders, {{"frame.glsl", "placed.glsl", "section.vert"}, {"section.frag"}});
  if (!line) return line.error();
  return SectionPass(std::move(*line));
}

SectionPass::SectionPass(gl::Program line) : line_(std::move(line)) {
  line_.bind_block("Frame", kFrameBlock);
}

void SectionPass::draw(const Subject& subject, int height) const {
  if (shown_section(subject.options) == nullptr) return;
  const SectionClip clip(subject.options);
  glEnable(GL_DEPTH_TEST);
  glDepthFunc(GL_EQUAL);
  glDepthMask(GL_FALSE);
  glEnable(GL_BLEND);
  glBlendFuncSeparate(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_ZERO, GL_ONE_MINUS_SRC_ALPHA);
  if (subject.options.cull_backs) glEnable(GL_CULL_FACE);
  line_.use();
  line_.set("wide", kWide * std::max(1.0f, static_cast<float>(height) / kPictureHeight));
  for_each_body(subject, [&](BodyId, const Body& body, const BodyPicture& picture) {
    picture.draw(line_, subject.space, body.placement);
  });
  glDisable(GL_CULL_FACE);
  glDisable(GL_BLEND);
  glDepthMask(GL_TRUE);
  glDepthFunc(GL_LESS);
}

}  // namespace kerf
