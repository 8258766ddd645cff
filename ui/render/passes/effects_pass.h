#pragma once

#include "ui/gl/stream.h"
#include "ui/render/bodies/shaders.h"
#include "ui/render/passes/effects.h"

namespace kerf {

// Draws burnt places, sparks as streaks that shine, and smoke as soft discs, over a picture whose depth
// buffer hides what lies behind its surfaces.
class EffectsPass {
 public:
  explicit EffectsPass(Shaders& shaders);

  // Draws into the bound picture. O(particles * log(particles)).
  void draw(const Effects& effects, const FrameSpace& space);

 private:
  // The corners of a quad are spread in the shader.
  struct Corner {
    glm::vec3 at;       // frame
    glm::vec3 towards;  // where the streak begins; the same as `at` for a disc
    glm::vec2 across;   // -1 .. 1 over the quad
    glm::vec2 look;     // half the width in the frame's unit, heat or opacity
  };
  void draw_scorches(const std::vector<Scorch>& scorches, const FrameSpace& space);
  void draw_sparks(const std::vector<Spark>& sparks, const FrameSpace& space);
  void draw_smoke(const std::vector<Puff>& puffs, const FrameSpace& space);
  void send(const std::vector<Corner>& corners);
  static void add_quad(std::vector<Corner>& corners, Corner corner);

  gl::Program sparks_, smoke_, scorches_;
  gl::Stream<Corner> corners_{gl::ItemsAre::kVertices,
                              {{3, offsetof(Corner, at)},
                               {3, offsetof(Corner, towards)},
                               {2, offsetof(Corner, across)},
                               {2, offsetof(Corner, look)}}};
};

}  // namespace kerf
