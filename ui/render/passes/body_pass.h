#pragma once

#include "ui/render/bodies/body_marks.h"
#include "ui/render/bodies/shaders.h"
#include "ui/render/bodies/subject.h"
#include "ui/render/passes/coloured_lines.h"

namespace kerf {

// Draws the marks of ViewOptions::bodies over everything: contacts as their normals, the redder the larger
// the impulse; colliders as chords and small crosses at their points; centres of mass as crosses, coloured by
// whether the body moves, sleeps or is pinned; joints as their axes, hubs with a circle around it, and welds
// as crosses.
class BodyPass {
 public:
  explicit BodyPass(Shaders& shaders);

  // Draws over the bound picture. Precondition: the uniform block of the frame is bound.
  void draw(const Subject& subject, double diagonal);

 private:
  ColouredLines lines_;
};

}  // namespace kerf
