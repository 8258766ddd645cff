#pragma once

#include "core/document/document.h"
#include "ui/gl/framebuffer.h"
#include "ui/gl/offscreen_context.h"
#include "ui/render/picture.h"
#include "ui/render/renderer.h"

namespace kerf {

// Makes pictures of a world without a screen, one after the other while it changes. The OpenGL context is
// current while it lives.
class Studio {
 public:
  // Looks at a scene that is not cut yet. Fails without OpenGL and for a size that it has no room for.
  static Result<Studio> open(const Scene& scene, const PictureOptions& options);

  // What a step changed; null where that is not known.
  void follow(const World& world, const StepResult* step);
  void draw(const World& world, const std::optional<BeamPicture>& beam);
  // The last picture, whole or not at all.
  Status write(const std::filesystem::path& png) const;

 private:
  Studio(gl::OffscreenContext context, gl::Framebuffer picture, Renderer renderer);

  gl::OffscreenContext context_;
  gl::Framebuffer picture_;
  Renderer renderer_;
  CameraView view_;
  ViewOptions look_;
};

}  // namespace kerf
