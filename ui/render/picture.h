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

// Cuts the strokes of a scene. Unspecified settings of a stroke follow from the size of the world before
// the first stroke (see default_settings). Calls `told` after every step. Stops at the first step that
// fails, and if `progress` stops it; earlier cuts stay.
Status cut_strokes(Document& document, const std::vector<StrokePath>& strokes,
                   const std::function<void(const StepResult&)>& told, const Progress* progress = nullptr);

struct PictureOptions {
  int width = 1280, height = 720;   // pixels, 1 .. 16384
  std::optional<Vec3> eye, target;  // m; if both are empty, the scene's view or one from the front
  ShowOptions show;
  std::optional<SectionPlane> section;  // of ShowOptions::section; if empty, through the middle
  double spread = 0;                    // factor of the exploded view; see spread_pieces()
  bool antialias = true;
  double mark_scale = 1;  // see ViewOptions
  bool legends = true;    // see ViewOptions
  bool beam = false;      // draws the beam of the last stroke at its end
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

}  // namespace kerf
