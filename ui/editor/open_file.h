#pragma once

#include <filesystem>
#include <span>

#include "ui/editor/editor_state.h"
#include "ui/editor/file_loader.h"

namespace kerf {

// Opens scenes and meshes in place of what is open, all of them as bodies of one scene, or a journal alone:
// reads them, shows them, cuts the strokes that they bring and replays the journal, stands the camera before
// them. On failure everything stays as it was.
Status open_files(EditorState& state, Renderer& renderer, std::span<const std::filesystem::path> files);

// Opens what an editor that died has left, as unsaved work, in place of what is open. On failure everything
// stays as it was.
Status open_left_work(EditorState& state, Renderer& renderer, const LeftWork& left);

// The same with files that were read already.
void show_loaded(EditorState& state, Renderer& renderer, LoadedFiles loaded);

}  // namespace kerf
