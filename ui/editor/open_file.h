#pragma once

#include <filesystem>

#include "ui/editor/editor_state.h"

namespace kerf {

// Opens a scene or a mesh in place of what is open: reads it, shows it, cuts the strokes that it brings,
// stands the camera before it. On failure everything stays as it was.
Status open_file(EditorState& state, Renderer& renderer, const std::filesystem::path& file);

}  // namespace kerf
