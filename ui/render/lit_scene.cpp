#include "ui/render/lit_scene.h"

#include <algorithm>
#include <cmath>

#include "core/base/assert.h"

namespace kerf {

namespace {

constexpr int kContactPixels = 256;
constexpr int kContactBlurs = 3;
constexpr double kContactMargin = 1.5;  // of the larger side of the world seen from above
// Depth below the ground at which nothing is visible, as a fraction of the height of the world.
constexpr double kHidden = 0.1;
constexpr double kRadius = 14;  // of the disc, in diagonals of the world

constexpr float kPaperDark = 0.5f;  // opacity of the paper's quad
constexpr gl::Stencil kLitPixels{.test = GL_EQUAL};

bool shows_edges(const ViewOptions& options) { return options.show.wire || options.show.face_numbers; }

bool casts_shadows(const ViewOptions& options) {
  return options.show.shadows == Shadows::kAll || options.show.shadow_compare;
}

}  // namespace

GroundPass::GroundPass(Shaders& shaders)
    : picture_({kContactPixels, kContactPixels, 1, true}),
      light_({kContactPixels, kContactPixels, 1, false}) {
  const auto disc = [&](std::vector<std::string> defines) {
    return shaders.load(
        {{"frame.glsl", "ground.vert"}, {"frame.glsl", "light.glsl", "ground.frag"}, defines});
  };
  programs_.disc = disc({});
  programs_.spot_disc = disc({"SPOT"});
  programs_.direct = shaders.load({{"frame.glsl", "ground.vert"},
                                   {"frame.glsl", "light.glsl", "direct.glsl", "ground.frag"},
                                   {"DIRECT"}});
  programs_.shadow = shaders.load({{"frame.glsl", "placed.glsl", "ground_shadow.vert"}, {"empty.frag"}});
  programs_.contact = shaders.load({{"frame.glsl", "placed.glsl", "contact.vert"}, {"contact.frag"}});
  programs_.blur = shaders.load({{"screen.vert"}, {"blur.frag"}});
  programs_.contact_light = shaders.load({{"screen.vert"}, {"contact_light.frag"}});
  glBindTexture(GL_TEXTURE_2D, picture_.colour_texture());
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR_MIPMAP_NEAREST);
  glGenerateMipmap(GL_TEXTURE_2D);
}

void GroundPass::place_under(const World::Bounds& world, UpAxis up, double height) {
  const Vec3 a = to_y_up(world.min, up), b = to_y_up(world.max, up);
  const World::Bounds bounds{glm::min(a, b), glm::max(a, b)};
  const double diagonal = bounds.diagonal() > 0 ? bounds.diagonal() : 1;
  const Vec3 size = bounds.max - bounds.min;
  height_ = height;
  tall_ = std::max(size.y, 0.05 * diagonal);
  middle_ = bounds.min + size * 0.5;
  radius_ = kRadius * diagonal;
  spacing_ = std::pow(10.0, std::floor(std::log10(diagonal))) / 5;
  contact_size_ = std::max({size.x, size.z, 0.05 * diagonal}) * kContactMargin;
}

void GroundPass::fill_in(FrameUniforms& frame, const FrameSpace& space) const {
  const Vec3 eye = space.turned(space.eye);
  const glm::vec3 middle((Vec3(middle_.x, height_, middle_.z) - eye) / space.unit);
  frame.ground = {middle.y, middle.x, middle.z, space.length(radius_)};
  const double five = 5 * spacing_;
  frame.grid = {space.length(std::fmod(eye.x, five)), space.length(std::fmod(eye.z, five)),
                space.length(spacing_), space.length(tall_)};
}

glm::vec4 GroundPass::contact_place(const FrameSpace& space) const {
  const Vec3 eye = space.turned(space.eye);
  const glm::vec3 corner(
      (Vec3(middle_.x - 0.5 * contact_size_, height_, middle_.z - 0.5 * contact_size_) - eye) / space.unit);
  return {corner.x, corner.z, 1 / space.length(contact_size_), 0};
}

void GroundPass::update_contact(const FrameSpace& space, const DrawBodies& bodies) {
  picture_.bind();
  glClearColor(0, 0, 0, 0);
  glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
  programs_.contact.use();
  programs_.contact.set("contact_place", contact_place(space));
  bodies(programs_.contact);
  const gl::ScopedState state({.depth = GL_NONE});
  blur_contact();
  light_.bind();
  programs_.contact_light.use();
  programs_.contact_light.set("picture", 0);
  no_vertices_.draw_screen();
}

void GroundPass::blur_contact() {
  programs_.blur.use();
  for (int i = 0; i < kContactBlurs; ++i) {
    const float step = static_cast<float>(i + 1) / kContactPixels;
    light_.bind();
    programs_.blur.set_texture("picture", 0, picture_.colour_texture());
    programs_.blur.set("stride", glm::vec4(step, 0, 0, 0));
    no_vertices_.draw_screen();
    picture_.bind();
    programs_.blur.set_texture("picture", 0, light_.colour_texture());
    programs_.blur.set("stride", glm::vec4(0, step, 0, 0));
    no_vertices_.draw_screen();
  }
  glBindTexture(GL_TEXTURE_2D, picture_.colour_texture());
  glGenerateMipmap(GL_TEXTURE_2D);
}

void GroundPass::draw(const FrameSpace& space, bool spot) const {
  const gl::Program& disc = spot ? programs_.spot_disc : programs_.disc;
  disc.use();
  disc.set_texture("contact", 0, light_.colour_texture());
  disc.set("contact_place", contact_place(space));
  draw_disc(space);
}

bool GroundPass::is_seen(const FrameSpace& space) const {
  return height_of(space.seen_from, space.up) > height_;
}

std::optional<float> GroundPass::hidden_below(const FrameSpace& space) const {
  if (!is_seen(space)) return std::nullopt;
  return space.length(height_ - kHidden * tall_ - height_of(space.eye, space.up));
}

void GroundPass::draw_disc(const FrameSpace& space) const {
  if (!is_seen(space)) return;
  no_vertices_.draw(GL_TRIANGLE_STRIP, 4);
}

bool GroundPass::project_shadow(const FrameSpace& space, const glm::vec4& light,
                                const DrawBodies& bodies) const {
  if (!is_seen(space) || light.w > 0 || light.y <= 0) return false;
  glClear(GL_STENCIL_BUFFER_BIT);
  const gl::ScopedState state({.depth = GL_NONE,
                               .writes_colour = false,
                               .writes_alpha = false,
                               .stencil = gl::Stencil{.reference = 1, .passed = GL_REPLACE}});
  programs_.shadow.use();
  programs_.shadow.set("light", light);
  bodies(programs_.shadow);
  return true;
}

void GroundPass::add_light(const FrameSpace& space, const glm::vec4& light, const glm::vec4& colour) const {
  programs_.direct.use();
  programs_.direct.set("light", light);
  programs_.direct.set("light_colour", colour);
  draw_disc(space);
}

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
  const glm::vec4 colour = light_colour(l, subject.space);
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
