#pragma once

#include <optional>

#include "ui/gl/framebuffer.h"
#include "ui/gl/program.h"
#include "ui/render/subject.h"

namespace kerf {

// A thin line around the pieces that are selected, also where something stands before them.
class OutlinePass {
 public:
  static Result<OutlinePass> create(const std::filesystem::path& shaders);

  // Over the picture, which is bound again after. Costs nothing where nothing is selected.
  void draw(const Subject& subject, const gl::Framebuffer& picture);

 private:
  OutlinePass(gl::Program faces, gl::Program outline);

  gl::Program faces_, outline_;
  gl::VertexArray no_vertices_;
  std::optional<gl::Framebuffer> mask_;
};

}  // namespace kerf
