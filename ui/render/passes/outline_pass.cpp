#include "ui/render/passes/outline_pass.h"

#include "ui/gl/state.h"
#include "ui/render/view/box_palette.h"
#include "ui/render/view/overlay_colours.h"
#include "ui/render/view/scaled_width.h"
#include "ui/render/view/section_clip.h"

namespace kerf {

namespace {

constexpr float kOutlineWidth = 1.6f;  // see scaled_width

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
  gl::ScopedState state({.depth = GL_NONE});
  faces_.use();
  faces_.set("only", 1);
  faces_.set("body", 255);
  draw_selected(subject);

  picture.bind();
  state.set({.depth = GL_NONE, .blend = gl::kOver});
  outline_.use();
  outline_.set_texture("mask", 0, mask_->colour_texture());
  outline_.set("colour", srgb(selection_colour(subject.options.tree.palette)));
  outline_.set("wide", scaled_width(kOutlineWidth, shape.height));
  no_vertices_.draw_screen();
}

}  // namespace kerf
