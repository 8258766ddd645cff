#pragma once

#include <filesystem>
#include <nlohmann/json_fwd.hpp>

#include "ui/editor/state.h"

namespace kerf {

// A report of the session: frame times (frames, frame_ms,
// between_pictures_ms, while_cutting), memory (process_bytes, memory_bytes as the Statistics panel shows it),
// the work (strokes, faces, faces_removed, removed_area, last_stroke, pieces, undo_depth, recuts, bodies,
// files), and what the window shows (pieces_chosen, pieces_hidden, spread, message, messages, view, lights,
// pixels_that_rays_have_otherwise, split, layout). Tests of the window read it.
nlohmann::ordered_json editor_report(const EditorState& state);
// Writes it to a file, whole or not at all.
Status write_editor_report(const EditorState& state, const std::filesystem::path& file);

}  // namespace kerf
