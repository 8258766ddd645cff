#pragma once

#include "ui/gl/state.h"
#include "ui/render/bodies/shaders.h"
#include "ui/render/bodies/subject.h"

namespace kerf {

// Draws the removed surface over the picture, as a faint veil or filled red.
class VeilPass {
 public:
  explicit VeilPass(Shaders& shaders);

  // Draws into the bound framebuffer, with depth test, after all opaque surfaces.
  enum class Style { kVeil, kRed };
  void draw(const Subject& subject, Style style) const;

 private:
  void draw_what_is_away(const Subject& subject) const;

  gl::Program veil_, faces_;
};

// Draws the removed surface with a state, slightly behind the remaining one, so that it is visible only where
// faces are missing. Bodies are numbered from 1 to 127 cyclically. Precondition: `program`, which contains
// veil.vert, is in use.
void draw_removed(const Subject& subject, const gl::Program& program, gl::State state);

}  // namespace kerf
