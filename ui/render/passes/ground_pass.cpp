#include "ui/render/passes/ground_pass.h"

#include <cmath>

#include "ui/gl/draw_state.h"

namespace kerf {

namespace {

constexpr int kContactPixels = 256;
constexpr int kContactBlurs = 3;
constexpr double kContactMargin = 1.5;  // of the larger side of the world seen from above
// of the height of the world: depth below the ground from which nothing is visible
constexpr double kHidden = 0.1;
constexpr double kRadius = 14;  // of the disc, in diagonals of the world

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

}  // namespace kerf
