#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include "core/base/geometry.h"
#include "core/base/result.h"
#include "core/document/document.h"
#include "core/document/journal.h"
#include "core/document/stroke_path.h"
#include "ui/gl/buffers.h"
#include "ui/gl/context.h"
#include "ui/render/renderer.h"
#include "ui/render/view/view_options.h"

namespace kerf {

// Cuts the strokes of a scene. Unspecified settings of a stroke follow from the size of the world before the
// first stroke (see default_settings). Calls `told` after every step. Stops at the first step that fails, or
// if `progress` stops it; earlier cuts remain.
Status cut_strokes(Document& document, const std::vector<StrokePath>& strokes,
                   const std::function<void(const StepResult&)>& told, const Progress* progress = nullptr);

struct PictureOptions {
  int width = 1280, height = 720;   // pixels, 1 .. 16384
  std::optional<Vec3> eye, target;  // m; if both are empty, the scene's view or one from the front
  ShowOptions show;
  std::optional<SectionPlane> section;  // of ShowOptions::section; if empty, through the middle
  double spread = 0;                    // factor of the exploded view; see spread_pieces()
  bool antialias = true;                // as far as the memory of OpenGL suffices
  double mark_scale = 1;                // see ViewOptions
  bool legends = true;                  // see ViewOptions
  bool beam = false;                    // draws the beam of the last stroke at its end
};

// Returns the options of an image of this size for a scene. The error names `file`, the scene's.
Result<PictureOptions> options_for(const std::filesystem::path& file, const Scene& scene, int width,
                                   int height);

class Document;
class OffscreenRenderer;

// A rendered image and its document; neither is null.
struct RenderedImage {
  std::shared_ptr<const Document> document;
  std::shared_ptr<OffscreenRenderer> renderer;
};

// Renders the content of a file without a window, after cutting the strokes of a scene or replaying the
// commands of a journal. Fails if OpenGL is not available or a stroke cannot be cut.
Result<RenderedImage> draw_picture(OpenedFile work, const PictureOptions& options);

// Renders like draw_picture() and writes a PNG atomically. Also fails if the PNG cannot be written.
Status render_picture(OpenedFile work, const PictureOptions& options, const std::filesystem::path& png);

// Renders a sequence of images of a changing world without a window. Its OpenGL context is current while it
// exists.
class OffscreenRenderer {
 public:
  // Precondition: the scene is uncut. Without an eye, a target and a view of the scene, the view also frames
  // the meshes that the journal adds; this reads their files. Fails if the eye is the target, or if OpenGL is
  // not available or does not support the size.
  static Result<OffscreenRenderer> open(const Scene& scene, const PictureOptions& options,
                                        const Journal& journal = {});

  // Follows a change of the world; `step` is null if the changes are unknown.
  void follow(const World& world, const StepResult* step);
  // Explodes the pieces of the world from the next image on; see spread_pieces().
  void spread(const World& world, double share) { spread_pieces(world, share, look_); }
  // Draws the component graph around the last stroke of the document from the next image on, if the options
  // request it. Linear in the faces of the cut bodies.
  void show_graph(const Document& document);
  // Draw the enabled contacts, colliders and centres of mass from the next image on: of the last tick of
  // the document, or as the next tick of a world would find them.
  void show_bodies(const Document& document);
  void show_bodies_ahead(const World& world);
  const CameraView& view() const { return view_; }
  ViewOptions& look() { return look_; }
  const gl::Framebuffer& framebuffer() const { return picture_; }
  void draw(const World& world, const std::optional<BeamPicture>& beam);
  // Writes the last image as a PNG atomically.
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
  std::filesystem::path folder;   // existing; receives frame-00000.png and so on
};

// Renders the replay of a document as a film of numbered PNGs. Ticks are filmed in real time. In strokes the
// beam moves at a constant speed of one diagonal of the world in four seconds, measured at its emitter or in
// the middle of the world, whichever is faster; a stroke during which ticks take longer lasts as long as
// these. The film pauses for half a second before the first stroke and after each stroke or other command
// except AdvanceTime, unless bodies are in motion, and for a second at the end.
class Film {
 public:
  // Writes the first frames, of an uncut scene, in a view for its journal. Fails like
  // OffscreenRenderer::open, or if a frame cannot be written.
  static Result<Film> begin(const Scene& scene, FilmOptions options, const Journal& journal = {});

  // Must be called after each step of the document, which contains at most one move of the beam. `step`
  // holds its changes, or is null if they are unknown. Fails if a frame cannot be written.
  Status follow(const Document& document, const StepResult* step);
  // Like follow(), but writes no frames.
  void skip(const Document& document, const StepResult* step);
  // Writes the last frames and removes those of an earlier, longer film from the folder. Fails if a frame
  // cannot be written or removed.
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
  Ticks ticks_ = 0;   // of the world's clock, filmed so far
  double ahead_ = 0;  // s of filmed ticks in a stroke that its moves do not cover yet
  Pose beam_;         // last pose
  size_t frames_ = 0;
};

}  // namespace kerf
