#include "ui/render/lit_scene.h"

#include <algorithm>

#include "core/base/assert.h"
#include "ui/render/bodies/body_picture.h"
#include "ui/render/shadow_pass.h"

namespace kerf {

namespace {

constexpr float kPaperDark = 0.5f;  // opacity of the paper's quad
constexpr gl::Stencil kLitPixels{.test = GL_EQUAL};

bool shows_edges(const ViewOptions& options) { return options.show.wire || options.show.face_numbers; }

bool casts_shadows(const ViewOptions& options) {
  return options.show.shadows == Shadows::kAll || options.show.shadow_compare;
}

}  // namespace

LitScene::BodyPrograms::BodyPrograms(Shaders& shaders, Maps maps) {
  const auto load = [&](std::vector<std::string> defines) {
    return shaders.load({{"frame.glsl", "placed.glsl", "body.vert"},
                         {"frame.glsl", "light.glsl", "direct.glsl", "body.frag"},
                         std::move(defines)});
  };
  for (size_t i = 0; i < ambient.size(); ++i) {
    std::vector<std::string> defines;
    if (maps == Maps::kTextured) defines.emplace_back("TEXTURED");
    for (auto [bit, name] : {std::pair{kWire, "WIRE"}, std::pair{kRim, "RIM"}, std::pair{kSpot, "SPOT"}}) {
      if (i & bit) defines.emplace_back(name);
    }
    ambient[i] = load(defines);
    defines.emplace_back("DIRECT");
    if (i < direct.size()) direct[i] = load(defines);
  }
  for (size_t i = 0; i < glow.size() && maps == Maps::kNone; ++i) {
    std::vector<std::string> defines{"RIM", "GLOW"};
    if (i & kWire) defines.emplace_back("WIRE");
    glow[i] = load(std::move(defines));
  }
}

LitScene::LitScene(Shaders& shaders)
    : body_(shaders, Maps::kNone),
      sky_(shaders.load({{"screen.vert"}, {"frame.glsl", "light.glsl", "sky.frag"}})),
      darken_(shaders.load({{"screen.vert"}, {"solid.frag"}})),
      ground_(shaders),
      shadows_(shaders),
      tone_(shaders) {}

void LitScene::load_textured_programs(const Subject& subject) {
  const bool any =
      std::ranges::any_of(subject.bodies, [](const auto& entry) { return entry.second.is_textured(); });
  draws_maps_ = any && subject.options.textures;
  if (!any || textured_ || lacks_textured_) return;
  Shaders shaders;
  textured_.emplace(shaders, Maps::kTextured);
  lacks_textured_ = !shaders.status();
  if (lacks_textured_) textured_.reset();
}

// Draws the kept side of the section plane of the bodies. use(programs) starts to use one of them and returns
// it.
template <typename Use>
void LitScene::draw_section(const Subject& subject, const Use& use) const {
  const SectionClip clip(subject.options);
  for (const BodyPrograms* programs : {&body_, textured_ ? &*textured_ : nullptr}) {
    if (!programs) continue;
    const gl::Program& program = use(*programs);
    ramps_.bind(program);
    for_each_body(subject, [&](BodyId, const Body& body, const BodyPicture& picture) {
      const bool by_maps = textured_ && draws_maps_ && picture.is_textured();
      if (by_maps == (programs != &body_)) picture.draw(program, subject.space, body.placement);
    });
  }
}

void LitScene::draw_without_lights(const Subject& subject) const {
  glClear(GL_DEPTH_BUFFER_BIT | GL_STENCIL_BUFFER_BIT);
  gl::ScopedState state({.culled = subject.culled()});
  draw_section(subject, [&](const BodyPrograms& programs) -> const gl::Program& {
    const gl::Program& body = programs.ambient[variant_ + (spot_ ? kSpot : 0)];
    body.use();
    return body;
  });
  state.set({});
  ground_.draw(subject.space, spot_);
  state.set({.depth = GL_LEQUAL});
  sky_.use();
  no_vertices_.draw_screen();
}

void LitScene::add_direct(const Subject& subject, size_t light, std::optional<gl::Stencil> where) const {
  const Light& l = subject.options.lights[light];
  const glm::vec4 place = light_in_frame(l, subject.space);
  const glm::vec4 colour = light_colour(l, subject.space, subject.world.bounds().diagonal());
  gl::State adding{.depth = GL_EQUAL,
                   .writes_depth = false,
                   .culled = subject.culled(),
                   .blend = gl::kAdd,
                   .stencil = where};
  gl::ScopedState state(adding);
  draw_section(subject, [&](const BodyPrograms& programs) -> const gl::Program& {
    const gl::Program& body = programs.direct[variant_];
    body.use();
    body.set("light", place);
    body.set("light_colour", colour);
    return body;
  });
  const bool projected =
      subject.options.show.shadows == Shadows::kGround && !casts_shadows(subject.options) &&
      ground_.project_shadow(subject.space, place,
                             [&](const gl::Program& program) { draw_bodies(subject, program); });
  adding.culled = GL_NONE;
  if (projected) adding.stencil = kLitPixels;
  state.set(adding);
  ground_.add_light(subject.space, place, colour);
}

// Blends black over shadowed areas, and then adds the glow of rims again.
void LitScene::darken_shadows(const Subject& subject) const {
  // The quad is as far as the sky, which stays unchanged.
  gl::State shadowed{.depth = GL_GREATER,
                     .writes_depth = false,
                     .blend = gl::Blend{GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_ZERO, GL_ONE},
                     .stencil = gl::Stencil{.test = GL_NOTEQUAL}};
  gl::ScopedState state(shadowed);
  darken_.use();
  darken_.set("colour", glm::vec4(0, 0, 0, kPaperDark));
  no_vertices_.draw_screen();
  if (!(variant_ & kRim)) return;
  shadowed.depth = GL_EQUAL;
  shadowed.culled = subject.culled();
  shadowed.blend = gl::Blend{GL_CONSTANT_COLOR, GL_ONE, GL_CONSTANT_COLOR, GL_ONE};
  state.set(shadowed);
  restore_glow(subject);
}

void LitScene::restore_glow(const Subject& subject) const {
  glBlendColor(kPaperDark, kPaperDark, kPaperDark, 0);
  const gl::Program& glow = body_.glow[variant_ & kWire];
  glow.use();
  ramps_.bind(glow);
  const SectionClip clip(subject.options);
  draw_bodies(subject, glow);
}

void LitScene::add_shadowed(const Subject& subject, size_t light, ShadowMethod method) {
  shadows_.count(subject, light, method, ground_.hidden_below(subject.space));
  if (subject.options.shadow.paper_look) {
    darken_shadows(subject);
  } else {
    add_direct(subject, light, kLitPixels);
  }
}

void LitScene::add_light(const Subject& subject, size_t light) {
  const ShadowOptions& shadow = subject.options.shadow;
  if (!subject.options.show.shadow_compare) return add_shadowed(subject, light, shadow.method);
  const int w = linear_->shape().width, h = linear_->shape().height;
  const int split = static_cast<int>(std::clamp(shadow.split, 0.0, 1.0) * w);
  glEnable(GL_SCISSOR_TEST);
  glScissor(0, 0, split, h);
  add_shadowed(subject, light, shadow.method);
  glScissor(split, 0, w - split, h);
  add_shadowed(subject, light, shadow.beside);
  glDisable(GL_SCISSOR_TEST);
}

void LitScene::draw(const Subject& subject, const Shining& shining, const gl::Framebuffer& canvas) {
  KERF_ASSERT(is_frame_bound());
  load_textured_programs(subject);
  variant_ = (shows_edges(subject.options) ? kWire : 0) + (shining.rims ? kRim : 0);
  spot_ = shining.spot;
  gl::Framebuffer::Shape shape = canvas.shape();
  shape.colour = GL_RGBA16F;
  if (!linear_ || !(linear_->shape() == shape) || linear_beside_ != canvas.name()) {
    linear_.emplace(shape, canvas);
    linear_beside_ = canvas.name();
  }
  linear_->bind();
  draw_without_lights(subject);
  const size_t lights = std::min(subject.options.lights.size(), kMaxLights);
  const bool shadowed = casts_shadows(subject.options);
  for (size_t i = 0; i < lights; ++i) {
    if (!shadowed || subject.options.shadow.paper_look) add_direct(subject, i, std::nullopt);
  }
  for (size_t i = 0; shadowed && i < lights; ++i) add_light(subject, i);
  shadows_.drop_unused();
  tone_.draw(*linear_, canvas);
}

}  // namespace kerf
