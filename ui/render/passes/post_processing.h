#pragma once

#include <functional>
#include <glm/vec2.hpp>
#include <optional>

#include "ui/gl/buffers.h"
#include "ui/render/bodies/body_picture.h"

namespace kerf {

// The destination of a frame: a rectangle of a framebuffer (0: the window) in pixels from its lower left
// corner.
struct Target {
  GLuint framebuffer = 0;
  int x = 0, y = 0;
  int width = 1, height = 1;
  glm::vec2 shift{0};  // sub-pixel shift of the scene [pixels]
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

// Draws the glow around bright pixels: those marked by the alpha channel of a frame are blurred at a
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

// The mean of several frames of the same scene, each shifted by a fraction of a pixel: edges are as smooth
// as with as many samples per pixel, but the work can be spread over time and abandoned after any frame.
// (P. Haeberli, K. Akeley: The accumulation buffer, 1990.)
class GatheredPicture {
 public:
  static constexpr int kPictures = 4;

  explicit GatheredPicture(Shaders& shaders);

  // Restarts with frames of this size in pixels. Precondition: width and height are positive.
  void begin(int width, int height);
  // Adds the next frame, which `draw` draws to the target it receives. Once complete, a further frame
  // replaces its share of the mean, so that it follows a slowly changing scene. Precondition: begin() was
  // called.
  void add(const std::function<void(const Target&)>& draw);
  bool complete() const { return count_ >= kPictures; }

  // Returns true if there are frames of the size of the target.
  bool can_show(const Target& target) const;
  // Copies the mean of the available frames to the target. Precondition: can_show(target).
  void show(const Target& target) const;
  void forget();

 private:
  void copy(const gl::Framebuffer& from, float share, const glm::ivec2& at) const;

  gl::Program copy_;
  gl::NoVertices no_vertices_;
  std::optional<gl::Framebuffer> next_, sum_;
  int count_ = 0;  // of added frames
};

}  // namespace kerf
