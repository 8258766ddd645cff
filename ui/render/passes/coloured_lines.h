#pragma once

#include <span>

#include "ui/gl/stream.h"
#include "ui/render/bodies/shaders.h"
#include "ui/render/view/overlay_colours.h"

namespace kerf {

// Draws lines of any colours, each with a dark one under it, so that they show on anything.
class ColouredLines {
 public:
  explicit ColouredLines(Shaders& shaders);

  struct Line {
    glm::vec3 from, to;  // in the coordinates of FrameSpace
    glm::vec4 colour;
  };
  // What a section plane leaves of a line: all or nothing, by its middle, or a part of it.
  enum class AtSection { kWhole, kPart };
  // `half_width` is in pixels of a picture of usual height; see line.glsl. Precondition: blending
  // is switched on.
  void draw(std::span<const Line> lines, float half_width, AtSection section = AtSection::kWhole);

 private:
  gl::Program program_;
  gl::Stream<Line> lines_{gl::ItemsAre::kInstances,
                          {{3, offsetof(Line, from)}, {3, offsetof(Line, to)}, {4, offsetof(Line, colour)}}};
};

}  // namespace kerf
