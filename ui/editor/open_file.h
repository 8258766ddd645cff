#pragma once

#include <filesystem>
#include <functional>
#include <span>

#include "ui/editor/editor_state.h"
#include "ui/editor/file_loader.h"

namespace kerf {

// Called when what was opened stands as its file has it; not `whole` where the user stopped that half-way.
using Opened = std::function<void(bool whole)>;

// Opens scenes and meshes in place of what is open, all of them as bodies of one scene, or a journal alone:
// reads them, shows them, stands the camera before them. The strokes that they bring and the journal become
// the state's long_change. On failure everything stays as it was.
Status open_files(EditorState& state, Renderer& renderer, std::span<const std::filesystem::path> files,
                  Opened then);

// Opens what an editor that died has left, as unsaved work, in place of what is open. On failure everything
// stays as it was.
Status open_left_work(EditorState& state, Renderer& renderer, const LeftWork& left, Opened then);

// The same with files that were read already.
void show_loaded(EditorState& state, Renderer& renderer, LoadedFiles loaded, Opened then);

}  // namespace kerf
