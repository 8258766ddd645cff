#pragma once

#include <functional>
#include <optional>

#include "ui/gl/framebuffer.h"
#include "ui/render/bodies/body_picture.h"
#include "ui/render/view/frame_space.h"

namespace kerf {

// The floor: a matt disc with a grid. Surfaces close to it darken it softly, and colour the ground around
// them.
class GroundPass {
 public:
  explicit GroundPass(Shaders& shaders);

  // Places the ground under these bounds, at this height [m] along the up axis.
  void place_under(const World::Bounds& world, UpAxis up, double height);
  void fill_in(FrameUniforms& frame, const FrameSpace& space) const;

  // Draws all bodies with the given program, only for the shading of the ground.
  using DrawBodies = std::function<void(const gl::Program&)>;

  // Recomputes the contact shading. Changes the bound framebuffer. Precondition: the state is gl::State().
  void update_contact(const FrameSpace& space, const DrawBodies& bodies);
  // Draws the ground without lights, after the bodies and before the sky. `spot`: the spot of the beam
  // lights it. No-op if the eye is below the ground.
  void draw(const FrameSpace& space, bool spot) const;
  // Draws its shape with the program in use, which contains ground.vert.
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

}  // namespace kerf
