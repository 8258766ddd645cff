#pragma once

#include <optional>

#include "ui/gl/draw_state.h"
#include "ui/gl/framebuffer.h"
#include "ui/gl/program.h"
#include "ui/render/bodies/body_picture.h"

namespace kerf {

// Clears the bound framebuffer and draws every face of every body, with depth, as a value that identifies
// it. Back faces are omitted if the options cull them. `faces` is the program of faces.vert and mark.frag;
// it is in use afterwards.
void draw_marked_faces(const Subject& subject, const gl::Program& faces);

// Draws a thin outline around selected pieces, even if other surfaces hide them.
class OutlinePass {
 public:
  explicit OutlinePass(Shaders& shaders);

  // Draws over `picture` and leaves it bound. No cost if no piece is selected.
  void draw(const Subject& subject, const gl::Framebuffer& picture);

 private:
  void draw_selected(const Subject& subject) const;

  gl::Program faces_, outline_;
  gl::NoVertices no_vertices_;
  std::optional<gl::Framebuffer> mask_;
};

// Draws the removed surface as a faint veil or in solid red.
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

// Draws the removed surface with a state, slightly behind the remaining one, so that it is visible only
// where faces are missing. Bodies are numbered from 1 to 127 cyclically. Precondition: `program`, which
// contains veil.vert, is in use.
void draw_removed(const Subject& subject, const gl::Program& program, gl::State state);

}  // namespace kerf
