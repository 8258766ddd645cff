#include "ui/render/passes/surface_overlays.h"

#include "ui/gl/draw_state.h"
#include "ui/render/bodies/body_picture.h"
#include "ui/render/view/colours.h"
#include "ui/render/view/frame_space.h"

namespace kerf {

void draw_marked_faces(const Subject& subject, const gl::Program& faces) {
  glClearColor(0, 0, 0, 0);
  glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
  const gl::ScopedState state({.culled = subject.culled()});
  const SectionClip clip(subject.options);
  faces.use();
  faces.set("only", 0);
  int number = 0;
  for_each_body(subject, [&](BodyId, const Body& body, const BodyPicture& picture) {
    faces.set("body", (number++ % 127) + 1);
    picture.bind(faces, subject.space, body.placement);
    picture.faces().draw_numbered(faces);
  });
}

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

namespace {

constexpr gl::DepthOffset kBehindSurfaces{1.5f, 24};

struct Look {
  glm::vec4 fill, edge;
};
Look look_of(VeilPass::Style style) {
  if (style == VeilPass::Style::kVeil) return {{0.34f, 0.44f, 0.56f, 0.15f}, {0.42f, 0.53f, 0.66f, 0.26f}};
  return {{0.30f, 0.016f, 0.012f, 1}, {0.62f, 0.10f, 0.07f, 1}};
}

}  // namespace

void draw_removed(const Subject& subject, const gl::Program& program, gl::State state) {
  state.offset = kBehindSurfaces;
  const gl::ScopedState scope(state);
  const SectionClip clip(subject.options);
  int number = 0;
  for_each_body(subject, [&](BodyId, const Body& body, BodyPicture& picture) {
    program.set("body", (number++ % 127) + 1);
    program.set("frame_from_body", subject.space.from_body(body.placement, picture.faces().frame()));
    picture.faces().draw_removed(body.mesh);
  });
}

VeilPass::VeilPass(Shaders& shaders)
    : veil_(shaders.load({{"frame.glsl", "veil.vert"}, {"frame.glsl", "light.glsl", "veil.frag"}})),
      faces_(shaders.load({{"frame.glsl", "placed.glsl", "faces.vert"}, {"mark.frag"}})) {}

// Writes only depth: hidden or displaced pieces are not removed, so no veil replaces them.
void VeilPass::draw_what_is_away(const Subject& subject) const {
  const gl::ScopedState state({.writes_colour = false, .writes_alpha = false});
  faces_.use();
  faces_.set("only", 2);
  const SectionClip clip(subject.options);
  for_each_body(subject, [&](BodyId, const Body& body, BodyPicture& picture) {
    if (picture.looks().any_away()) picture.draw(faces_, subject.space, body.placement);
  });
}

void VeilPass::draw(const Subject& subject, Style style) const {
  draw_what_is_away(subject);
  const bool opaque = style == Style::kRed;
  const Look look = look_of(style);
  veil_.use();
  veil_.set("fill", look.fill);
  veil_.set("edge", look.edge);
  draw_removed(
      subject, veil_,
      opaque ? gl::State{.writes_alpha = false} : gl::State{.writes_depth = false, .blend = gl::kOver});
}

}  // namespace kerf
