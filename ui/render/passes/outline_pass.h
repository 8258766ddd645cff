#pragma once

#include <optional>

#include "ui/gl/framebuffer.h"
#include "ui/render/bodies/shaders.h"
#include "ui/render/bodies/subject.h"

namespace kerf {

// Draws a thin outline around selected pieces, also where other surfaces hide them.
class OutlinePass {
 public:
  explicit OutlinePass(Shaders& shaders);

  // Draws over `picture` and leaves it bound. Costs nothing if no piece is selected.
  void draw(const Subject& subject, const gl::Framebuffer& picture);

 private:
  void draw_selected(const Subject& subject) const;

  gl::Program faces_, outline_;
  gl::NoVertices no_vertices_;
  std::optional<gl::Framebuffer> mask_;
};

}  // namespace kerf
