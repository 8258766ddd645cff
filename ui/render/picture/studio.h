#pragma once

#include "core/document/history/document.h"
#include "ui/gl/framebuffer.h"
#include "ui/gl/offscreen_context.h"
#include "ui/render/picture/picture.h"
#include "ui/render/renderer.h"
#include "ui/render/view/spread.h"

namespace kerf {

// Renders a sequence of pictures of a changing world without a screen. Its OpenGL context is current while it
// exists.
class Studio {
 public:
  // Precondition: the scene is not cut yet. Fails if OpenGL is not available or does not support the size.
  static Result<Studio> open(const Scene& scene, const PictureOptions& options);

  // Follows a change of the world; `step` is null if what changed is unknown.
  void follow(const World& world, const StepResult* step);
  // Draws the pieces of the world apart from the next picture on; see spread_pieces().
  void spread(const World& world, double share) { spread_pieces(world, share, look_); }
  // Draws the component graph around the last stroke of the document from the next picture on, if the options
  // of the picture ask for it. Linear in the faces of the bodies that were cut.
  void show_graph(const Document& document);
  // Draws what the switches for contacts, colliders and centres of mass ask for from the next picture on: of
  // the last tick of the document, or what the next tick of a world would find.
  void show_bodies(const Document& document);
  void show_bodies_ahead(const World& world);
  const CameraView& view() const { return view_; }
  ViewOptions& look() { return look_; }
  // What the last picture was drawn on.
  const gl::Framebuffer& framebuffer() const { return picture_; }
  // Draws a picture.
  void draw(const World& world, const std::optional<BeamPicture>& beam);
  // Writes the last picture as a PNG, whole or not at all.
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
