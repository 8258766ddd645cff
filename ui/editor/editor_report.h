#pragma once

#include <filesystem>

#include "ui/editor/editor_state.h"

namespace kerf {

// What the editor did, as JSON: frames, frame_ms {p50, p99, max}, strokes, faces, faces_removed, pieces,
// undo_depth, memory_bytes {meshes, trees, shading, shadows, graphics, history, process} as the statistics
// show them.
Status write_editor_report(const EditorState& state, const std::filesystem::path& file);

}  // namespace kerf
