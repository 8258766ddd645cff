#pragma once

#include <array>
#include <functional>
#include <optional>

#include "ui/gl/buffers.h"
#include "ui/gl/program.h"
#include "ui/render/bodies/body_picture.h"
#include "ui/render/passes/heat_colours.h"
#include "ui/render/passes/post_processing.h"
#include "ui/render/shadow_pass.h"
#include "ui/render/view/camera.h"

namespace kerf {

// The ground: a matt disc with a grid. Surfaces close to it darken and tint it softly (contact shading).
class GroundPass {
 public:
  explicit GroundPass(Shaders& shaders);

  // Places the ground below these bounds, at this height [m] along the up axis.
  void place_under(const World::Bounds& world, UpAxis up, double height);
  void fill_in(FrameUniforms& frame, const FrameSpace& space) const;

  // Draws all bodies with the given program, only for the shading of the ground.
  using DrawBodies = std::function<void(const gl::Program&)>;

  // Recomputes the contact shading. Changes the bound framebuffer. Precondition: the state is gl::State().
  void update_contact(const FrameSpace& space, const DrawBodies& bodies);
  // Draws the ground without lights, after the bodies and before the sky. `spot`: the spot of the beam
  // lights it. No-op if the eye is below the ground.
  void draw(const FrameSpace& space, bool spot) const;
  // Draws the disc with the program in use, which must contain ground.vert.
  void draw_disc(const FrameSpace& space) const;
  // The height in frame coordinates below which the ground hides everything; nullopt if the eye is below
  // it.
  std::optional<float> hidden_below(const FrameSpace& space) const;
  // Adds a light, given as the uniforms of direct.glsl, with exactly the same depths as draw().
  void add_light(const FrameSpace& space, const glm::vec4& light, const glm::vec4& colour) const;

  // For frames without shadow volumes: projects the bodies onto the ground along a directional light from
  // above into the stencil, which is 0 outside this shadow. Returns false without effect for any other
  // light.
  bool project_shadow(const FrameSpace& space, const glm::vec4& light, const DrawBodies& bodies) const;

  double height() const { return height_; }

 private:
  struct Programs {
    gl::Program disc, spot_disc, direct, shadow, contact, blur, contact_light;
  };
  bool is_seen(const FrameSpace& space) const;
  glm::vec4 contact_place(const FrameSpace& space) const;
  void blur_contact();

  Programs programs_;
  gl::Framebuffer picture_;  // occluders above the ground
  gl::Framebuffer light_;    // the resulting shading and light on the ground
  gl::NoVertices no_vertices_;
  double height_ = 0, tall_ = 1, radius_ = 1, spacing_ = 1;  // m
  Vec3 middle_{0};                                           // of the world, +Y upwards
  double contact_size_ = 1;  // m, side of the square covered by the contact shading
};

// Draws bodies, ground and sky with their lights, in linear light: first everything in ambient light, then
// for each light its contribution outside its shadow.
class LitScene {
 public:
  explicit LitScene(Shaders& shaders);

  GroundPass& ground() { return ground_; }
  ShadowPass& shadows() { return shadows_; }
  const ShadowPass& shadows() const { return shadows_; }

  // The emissive parts of a frame.
  struct Shining {
    bool spot = false;  // the spot of the beam, which lights its environment
    bool rims = false;  // rims of cuts, and surfaces that are or were hot
  };

  // Draws into the colour and depth of `canvas`. Precondition: the uniform block of the frame is bound.
  void draw(const Subject& subject, const Shining& shining, const gl::Framebuffer& canvas);

 private:
  // Variants of the programs with and without wire, glowing rims and spot, so that unneeded terms are not
  // computed.
  static constexpr size_t kWire = 1, kRim = 2, kSpot = 4;
  enum class Maps { kNone, kTextured };
  struct BodyPrograms {
    BodyPrograms(Shaders& shaders, Maps maps);
    std::array<gl::Program, 8> ambient;
    std::array<gl::Program, 4> direct;  // without spot
    std::array<gl::Program, 2> glow;    // of rims, without spot and maps
  };

  void load_textured_programs(const Subject& subject);
  template <typename Use>
  void draw_section(const Subject& subject, const Use& use) const;
  void draw_without_lights(const Subject& subject) const;
  void add_light(const Subject& subject, size_t light);
  void add_shadowed(const Subject& subject, size_t light, ShadowMethod method);
  void add_direct(const Subject& subject, size_t light, std::optional<gl::Stencil> where) const;
  void darken_shadows(const Subject& subject) const;
  void restore_glow(const Subject& subject) const;

  BodyPrograms body_;
  std::optional<BodyPrograms> textured_;  // loaded for the first body with maps
  bool draws_maps_ = false;               // in this frame
  bool lacks_textured_ = false;           // these programs failed to load: maps are not drawn
  gl::Program sky_, darken_;
  GroundPass ground_;
  ShadowPass shadows_;
  TonePass tone_;
  HeatRamps ramps_;
  gl::NoVertices no_vertices_;
  size_t variant_ = 0;  // for the frame, without the spot
  bool spot_ = false;
  std::optional<gl::Framebuffer> linear_;
  GLuint linear_beside_ = 0;  // the canvas whose depth buffer it shares
};

}  // namespace kerf
