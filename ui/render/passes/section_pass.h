#pragma once

#include "ui/render/bodies/shaders.h"
#include "ui/render/bodies/subject.h"

namespace kerf {

// Draws a line where the section plane cuts faces.
class SectionPass {
 public:
  explicit SectionPass(Shaders& shaders);

  // Draws over the bound picture, whose depth is that of the bodies. Costs nothing without a section plane.
  // Precondition: the uniform block of the frame is bound.
  void draw(const Subject& subject, int height) const;

 private:
  gl::Program line_;
};

}  // namespace kerf
