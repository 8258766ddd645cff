#pragma once

#include "core/document/document.h"
#include "ui/gl/context.h"
#include "ui/gl/framebuffer.h"
#include "ui/render/picture.h"
#include "ui/render/renderer.h"
#include "ui/render/view/view_options.h"

namespace kerf {

// Renders a sequence of pictures of a changing world without a screen. Its OpenGL context is current while it
// exists.
class OffscreenRenderer {
 public:
  // Precondition: the scene is not cut yet. Fails if OpenGL is not available or does not support the size.
  static Result<OffscreenRenderer> open(const Scene& scene, const PictureOptions& options);

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
  OffscreenRenderer(gl::OffscreenContext context, gl::Framebuffer picture, Renderer renderer);

  gl::OffscreenContext context_;
  gl::Framebuffer picture_;
  Renderer renderer_;
  CameraView view_;
  ViewOptions look_;
};

struct FilmOptions {
  PictureOptions picture;
  double frames_per_second = 30;  // > 0
  std::filesystem::path folder;   // an existing folder, which receives frame-00000.png and so on
};

// Films the replay of a document as numbered PNGs. Ticks take as long in the film as they last. Strokes have
// a pace of the film's own: the beam moves at a constant speed of one diagonal of the world in four seconds,
// measured at its emitter or in the middle of the world, whichever is faster; a stroke during which more time
// passed by ticks takes that time. The film rests for half a second before the first stroke and after each
// stroke or other command except Advance, unless bodies are in motion, and for a second at the end.
class Film {
 public:
  // Writes the first frames, of a scene that is not cut yet. Fails like OffscreenRenderer::open, or if a
  // frame cannot be written.
  static Result<Film> begin(const Scene& scene, FilmOptions options);

  // To be called after each step of the document, which made one move of the beam at most. `step` is what the
  // step changed, or null if that is unknown. Fails if a frame cannot be written.
  Status follow(const Document& document, const StepResult* step);
  // Follows a step that the film leaves out: it takes no time and no frame shows it.
  void leave_out(const Document& document, const StepResult* step);
  // Writes the last frames.
  Status end(const Document& document);

 private:
  Film(OffscreenRenderer renderer, FilmOptions options, const World::Bounds& bounds);
  double seconds_of(const BeamMove& move) const;
  Status pass_ticks(const Document& document);
  std::optional<BeamPicture> beam_picture(const Document& document, const Pose& beam) const;
  Status pass(double seconds, const World& world, const std::optional<BeamPicture>& beam);

  OffscreenRenderer renderer_;
  FilmOptions options_;
  Vec3 middle_;
  double speed_;      // m/s
  double clock_ = 0;  // s of the film
  Ticks ticks_ = 0;   // of the world's clock that the film has shown
  double ahead_ = 0;  // s of ticks in a stroke that its moves have not taken yet
  Pose beam_;         // where it was last
  size_t frames_ = 0;
};

}  // namespace kerf
