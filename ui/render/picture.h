#pragma once

#include <filesystem>
#include <optional>

#include "core/base/result.h"
#include "core/base/vec3.h"
#include "core/document/opened_file.h"
#include "ui/render/section_plane.h"
#include "ui/render/show_options.h"

namespace kerf {

// How a picture is rendered.
struct PictureOptions {
  int width = 1280, height = 720;   // pixels, 1 .. 16384
  std::optional<Vec3> eye, target;  // m; if both are empty, the scene's view or one from the front
  ShowOptions show;
  std::optional<SectionPlane> section;  // where ShowOptions::section cuts; if empty, the middle
  double spread = 0;                    // how far pieces are drawn apart; see spread_pieces()
  bool antialias = true;
};

// Renders the content of a file without a screen and writes it as a PNG, whole or not at all. The strokes of
// a scene are cut, or the commands of a journal replayed, beforehand. Fails if OpenGL is not available, the
// file cannot be written or a stroke cannot be cut.
Status render_picture(OpenedFile work, const PictureOptions& options, const std::filesystem::path& png);

}  // namespace kerf
