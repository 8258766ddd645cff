#pragma once

#include <filesystem>

#include "ui/editor/editor_state.h"

namespace kerf {

// What the editor did, as JSON: frames, frame_ms {p50, p99, max}, strokes, faces, faces_removed, pieces,
// undo_depth.
Status write_editor_report(const EditorState& state, const std::filesystem::path& file);

}  // namespace kerf
