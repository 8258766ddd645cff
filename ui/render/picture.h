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
#include "ui/render/view/section_plane.h"
#include "ui/render/view/view_options.h"

namespace kerf {

// Cuts the strokes of a scene. Settings that a stroke does not specify follow from the size of the world
// before the first stroke (see default_settings). Calls `told` after every step. Stops at the first step that
// fails, and when `progress` stops it; what was cut until then stays cut.
Status cut_strokes(Document& document, const std::vector<StrokePath>& strokes,
                   const std::function<void(const StepResult&)>& told, const Progress* progress = nullptr);

// How a picture is rendered.
struct PictureOptions {
  int width = 1280, height = 720;   // pixels, 1 .. 16384
  std::optional<Vec3> eye, target;  // m; if both are empty, the scene's view or one from the front
  ShowOptions show;
  std::optional<SectionPlane> section;  // where ShowOptions::section cuts; if empty, the middle
  double spread = 0;                    // how far pieces are drawn apart; see spread_pieces()
  bool antialias = true;
  double mark_scale = 1;  // see ViewOptions
  bool legends = true;    // likewise
  bool beam = false;      // the beam of the last stroke is drawn where it ended
};

// The options of a picture of this size that shows what a scene asks for. The error names `file`, the
// scene's.
Result<PictureOptions> options_for(const std::filesystem::path& file, const Scene& scene, int width,
                                   int height);

class Document;
class OffscreenRenderer;

// A picture that a studio has drawn, and what it shows; neither is null.
struct DrawnPicture {
  std::shared_ptr<const Document> document;
  std::shared_ptr<OffscreenRenderer> renderer;
};

// Renders the content of a file without a screen: the strokes of a scene are cut, or the commands of a
// journal replayed, beforehand. Fails if OpenGL is not available or a stroke cannot be cut.
Result<DrawnPicture> draw_picture(OpenedFile work, const PictureOptions& options);

// Renders the content of a file as draw_picture() does and writes a PNG, whole or not at all. Also fails if
// the PNG cannot be written.
Status render_picture(OpenedFile work, const PictureOptions& options, const std::filesystem::path& png);

}  // namespace kerf
