#pragma once

#include <filesystem>
#include <optional>

#include "core/base/result.h"
#include "core/base/vec3.h"
#include "core/document/work.h"
#include "ui/render/show_options.h"

namespace kerf {

struct PictureOptions {
  int width = 1280, height = 720;   // pixels, 1 .. 16384
  std::optional<Vec3> eye, target;  // m; the scene's view or one from the front where both are empty
  ShowOptions show;
  bool antialias = true;
};

// Draws what a file holds without a screen and writes it as a PNG, whole or not at all. The strokes of a
// scene are cut and the commands of a journal replayed first. Fails without OpenGL, where the file cannot be
// written, and where a stroke of a scene cannot be cut.
Status render_picture(Work work, const PictureOptions& options, const std::filesystem::path& png);

}  // namespace kerf
