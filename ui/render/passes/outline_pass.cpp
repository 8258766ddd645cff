#include "ui/render/passes/outline_pass.h"

#include <algorithm>

#include "ui/render/view/box_palette.h"
#include "ui/render/view/scaled_width.h"
#include "ui/render/view/section_clip.h"

namespace kerf {

namespace {

constexpr float kOutlineWidth = 1.6f;  // see scaled_width

glm::vec4 screen_colour(uint32_t hex) {
  return glm::vec4(hex >> 16 & 255u, hex >> 8 & 255u, hex & 255u, 255u) / 255.0f;
}

}  // namespace

OutlinePass::OutlinePass(Shaders& shaders)
    : faces_(shaders.load({{"frame.glsl", "placed.glsl", "faces.vert"}, {"mark.frag"}})),
      outline_(shaders.load({{"screen.vert"}, {"frame.glsl", "outline.frag"}})) {}

void OutlinePass::draw_selected(const Subject& subject) const {
  const SectionClip clip(subject.options);
  for_each_body(subject, [&](BodyId, const Body& body, const BodyPicture& p) {
    if (p.looks().any_selected()) p.draw(faces_, subject.space, body.placement);
  });
}

void OutlinePass::draw(const Subject& subject, const gl::Framebuffer& picture) {
  bool any = false;
  for_each_body(subject,
                [&](BodyId, const Body&, const BodyPicture& p) { any = any || p.looks().any_selected(); });
  if (!any) return;
  const gl::Framebuffer::Shape shape{picture.shape().width, picture.shape().height, 1, false};
  if (!mask_ || !(mask_->shape() == shape)) mask_.emplace(shape);
  mask_->bind();
  glClearColor(0, 0, 0, 0);
  glClear(GL_COLOR_BUFFER_BIT);
  glDisable(GL_DEPTH_TEST);
  faces_.use();
  faces_.set("only", 1);
  faces_.set("body", 255);
  draw_selected(subject);

  picture.bind();
  glEnable(GL_BLEND);
  glBlendFuncSeparate(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_ZERO, GL_ONE_MINUS_SRC_ALPHA);
  outline_.use();
  glActiveTexture(GL_TEXTURE0);
  glBindTexture(GL_TEXTURE_2D, mask_->colour_texture());
  outline_.set("mask", 0);
  outline_.set("colour", screen_colour(selection_colour(subject.options.tree.palette)));
  outline_.set("wide", scaled_width(kOutlineWidth, shape.height));
  glBindVertexArray(no_vertices_.name());
  glDrawArrays(GL_TRIANGLES, 0, 3);
  glDisable(GL_BLEND);
  glEnable(GL_DEPTH_TEST);
}

}  // namespace kerf
