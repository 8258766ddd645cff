#pragma once

#include <functional>
#include <optional>

#include "ui/gl/framebuffer.h"
#include "ui/render/bodies/shaders.h"
#include "ui/render/passes/target.h"

namespace kerf {

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
