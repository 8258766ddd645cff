#pragma once

#include "ui/gl/program.h"
#include "ui/render/subject.h"

namespace kerf {

// The surface that is gone, over the picture: a faint veil, or filled red.
class VeilPass {
 public:
  static Result<VeilPass> create(const std::filesystem::path& shaders);

  // After everything opaque, into what is bound, with its depth.
  enum class Style { kVeil, kRed };
  void draw(const Subject& subject, Style style) const;

 private:
  VeilPass(gl::Program veil, gl::Program faces);
  void draw_what_is_away(const Subject& subject) const;

  gl::Program veil_, faces_;
};

// With a program of veil.vert in use: draws the surface that is gone a little behind what is left, so that it
// shows only where nothing is left. Bodies are numbered from 1 to 127, over and over.
void draw_removed(const Subject& subject, const gl::Program& program);

}  // namespace kerf
