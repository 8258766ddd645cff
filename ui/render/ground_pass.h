#pragma once

#include <functional>

#include "ui/gl/framebuffer.h"
#include "ui/gl/program.h"
#include "ui/render/frame_space.h"

namespace kerf {

// The floor that the world stands on: a matt disc with a grid, at the height of the world's lowest point. It
// darkens softly where something stands close above it.
class GroundPass {
 public:
  static Result<GroundPass> create(const std::filesystem::path& shaders);

  // The ground under these bounds.
  void place_under(const World::Bounds& bounds);
  void fill_in(FrameUniforms& frame, const FrameSpace& space) const;

  // Draws all bodies with the program given; what is drawn is seen by the ground alone.
  using DrawBodies = std::function<void(const gl::Program&)>;

  // Looks anew at how close what stands on it is. Changes the framebuffer that is bound.
  void update_contact(const FrameSpace& space, const DrawBodies& bodies);
  // After the bodies and before the sky: the ground without lights. `spot`: whether the beam lights it up.
  // Nothing is drawn for an eye under the ground.
  void draw(const FrameSpace& space, bool spot) const;
  // Its shape alone, for a program of ground.vert in use.
  void draw_disc(const FrameSpace& space) const;
  // What a light adds to it, in the uniforms of direct.glsl; where it was drawn it is drawn to the bit.
  void add_light(const FrameSpace& space, const glm::vec4& light, const glm::vec4& colour) const;

  // For pictures without shadow volumes: projects the bodies onto the ground, away from a directional light
  // above it, and turns the stencil test on so that only what lies outside this shadow passes. False for
  // another light; nothing is done then.
  bool project_shadow(const FrameSpace& space, const glm::vec4& light, const DrawBodies& bodies) const;

  double height() const { return height_; }

 private:
  GroundPass(gl::Program disc, gl::Program spot_disc, gl::Program direct, gl::Program shadow,
             gl::Program contact, gl::Program blur);
  glm::vec4 contact_place(const FrameSpace& space) const;
  void blur_contact();

  gl::Program disc_, spot_disc_, direct_, shadow_, contact_, blur_;
  gl::Framebuffer picture_, half_way_;
  gl::VertexArray no_vertices_;
  double height_ = 0, tall_ = 1, radius_ = 1, spacing_ = 1;  // m
  Vec3 middle_{0};
  double contact_size_ = 1;  // m, side of the square that the contact picture covers
};

}  // namespace kerf
