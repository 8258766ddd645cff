#pragma once

#include <vector>

#include "ui/gl/stream.h"
#include "ui/render/bodies/shaders.h"
#include "ui/render/bodies/stage_marks.h"
#include "ui/render/bodies/subject.h"
#include "ui/render/passes/coloured_lines.h"

namespace kerf {

// The colour of a kind of marks as 0xrrggbb (sRGB).
uint32_t colour_of(StageMarks::Kind kind);

// Draws what a stage of a cut did: translucent faces and volumes, and lines around faces and boxes. What a
// surface hides is not seen, except for the box that was visited last.
class StagePass {
 public:
  explicit StagePass(Shaders& shaders);

  // Draws ViewOptions::stage over the bound picture, whose depth buffer is used. O(marks).
  void draw(const Subject& subject);

 private:
  struct Corner {
    glm::vec3 at;
    glm::vec4 colour;
  };
  void draw_fills(const std::vector<Corner>& corners);

  gl::Program fills_;
  ColouredLines lines_;
  gl::Stream<Corner> corners_{gl::ItemsAre::kVertices,
                              {{3, offsetof(Corner, at)}, {4, offsetof(Corner, colour)}}};
};

}  // namespace kerf
