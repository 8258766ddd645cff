#pragma once

#include "ui/render/bodies/body_marks.h"
#include "ui/render/bodies/subject.h"
#include "ui/render/passes/coloured_lines.h"

namespace kerf {

// Draws the marks of ViewOptions::bodies over everything: contacts as their normals, the redder the larger
// the impulse; colliders as chords and small crosses at their points; centres of mass as crosses, coloured by
// whether the body moves, sleeps or is pinned; joints as their axes, hubs with a circle around it, and welds
// as crosses.
class BodyPass {
 public:
  static Result<BodyPass> create(const std::filesystem::path& shaders);

  // Draws over the bound picture. Precondition: the uniform block of the frame is bound.
  void draw(const Subject& subject, double diagonal);

 private:
  explicit BodyPass(ColouredLines lines) : lines_(std::move(lines)) {}

  ColouredLines lines_;
};

}  // namespace kerf
