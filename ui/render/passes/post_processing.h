#pragma once

#include <functional>
#include <glm/vec2.hpp>
#include <optional>

#include "ui/gl/buffers.h"
#include "ui/gl/framebuffer.h"
#include "ui/render/bodies/body_picture.h"

namespace kerf {

// The destination of a picture: a rectangle of a framebuffer (0: the window) in pixels from its lower left
// corner.
struct Target {
  GLuint framebuffer = 0;
  int x = 0, y = 0;
  int width = 1, height = 1;
  glm::vec2 shift{0};  // pixels by which the scene is drawn beside its place
};

// Maps the linear light of a scene to the eight bits of the screen, separately for every sample, so that
// edges against bright surfaces stay smooth.
class TonePass {
 public:
  explicit TonePass(Shaders& shaders);

  // Fills the colour of `to` and keeps its depth. Precondition: both have the same size and number of
  // samples.
  void draw(const gl::Framebuffer& scene, const gl::Framebuffer& to) const;

 private:
  gl::Program one_sample_, samples_;
  gl::NoVertices no_vertices_;
};

// Draws the glow around bright pixels: those that the alpha channel of a picture marks are blurred at a
// quarter and at a sixteenth of its resolution and added to it.
class BloomPass {
 public:
  explicit BloomPass(Shaders& shaders);

  // Draws `picture`, which has one sample per pixel, with its glow into the framebuffer `target` at x, y.
  void draw(const gl::Framebuffer& picture, GLuint target, int x, int y);

 private:
  struct Level {
    gl::Framebuffer glow, half_way;
    Level(int width, int height);
  };
  void fill(Level& level, GLuint from, int width, int height);

  gl::Program bright_, blur_, lay_over_;
  gl::NoVertices no_vertices_;
  std::optional<Level> near_, far_;
};

// The mean of several pictures of the same scene, each shifted by a part of a pixel: edges are as smooth as
// with as many samples per pixel, but the pictures can be drawn in different frames, so that the work can be
// given up between any two of them. (P. Haeberli, K. Akeley: The accumulation buffer, 1990.)
class GatheredPicture {
 public:
  static constexpr int kPictures = 4;

  explicit GatheredPicture(Shaders& shaders);

  // Starts anew with pictures of this size in pixels. Precondition: width and height are positive.
  void begin(int width, int height);
  // Adds the next picture, which `draw` draws to the target that it gets. Once the pictures are complete it
  // takes the place of their share of the mean, so that a scene that changes slowly is followed.
  // Precondition: begin() was called.
  void add(const std::function<void(const Target&)>& draw);
  bool complete() const { return count_ >= kPictures; }

  // Whether there are pictures of the size of the target.
  bool can_show(const Target& target) const;
  // Copies the mean of the pictures that are there to the target. Precondition: can_show(target).
  void show(const Target& target) const;
  // Forgets all pictures.
  void forget();

 private:
  void copy(const gl::Framebuffer& from, float share, const glm::ivec2& at) const;

  gl::Program copy_;
  gl::NoVertices no_vertices_;
  std::optional<gl::Framebuffer> next_, sum_;
  int count_ = 0;  // of pictures that were added
};

}  // namespace kerf
