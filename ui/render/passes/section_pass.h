#pragma once

#include "ui/gl/program.h"
#include "ui/render/bodies/subject.h"

namespace kerf {

// Draws a line where the section plane cuts faces.
class SectionPass {
 public:
  static Result<SectionPass> create(const std::filesystem::path& shaders);

  // Draws over the bound picture, whose depth is that of the bodies. Costs nothing without a section plane.
  // Precondition: the uniform block of the frame is bound.
  void draw(const Subject& subject, int height) const;

 private:
  explicit SectionPass(gl::Program line);

  gl::Program line_;
};

}  // namespace kerf
