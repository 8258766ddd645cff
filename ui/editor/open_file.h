#pragma once

#include <filesystem>
#include <span>

#include "ui/editor/editor_state.h"

namespace kerf {

// Opens scenes and meshes in place of what is open, all of them as bodies of one scene: reads them, shows
// them, cuts the strokes that they bring, stands the camera before them. On failure everything stays as it
// was.
Status open_files(EditorState& state, Renderer& renderer, std::span<const std::filesystem::path> files);

}  // namespace kerf
