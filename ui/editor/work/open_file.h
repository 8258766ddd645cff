#pragma once

#include "ui/editor/editor_state.h"
#include "ui/editor/work/file_loader.h"

namespace kerf {

// Shows what was read in place of what is open, and stands the camera before it.
void show_loaded(EditorState& state, Renderer& renderer, LoadedFiles loaded);

}  // namespace kerf
