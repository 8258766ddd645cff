#pragma once

#include <array>
#include <optional>

#include "ui/gl/draw_state.h"
#include "ui/gl/framebuffer.h"
#include "ui/render/passes/ground_pass.h"
#include "ui/render/passes/heat_colours.h"
#include "ui/render/passes/post_processing.h"
#include "ui/render/shadow_pass.h"

namespace kerf {

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
  bool lacks_textured_ = false;           // they failed to load, so that maps are left out
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
