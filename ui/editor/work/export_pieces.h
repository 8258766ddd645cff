#pragma once

#include <filesystem>

#include "ui/editor/editor_state.h"

namespace kerf {

// "piece.obj" as "piece-2.obj".
std::filesystem::path numbered(const std::filesystem::path& file, size_t number);

// Writes the chosen pieces where they stand, in the format of the file's ending: one piece to the file
// itself, several to numbered files beside it. How many were written; what was written before a failure
// stays.
Result<size_t> export_chosen(const EditorState& state, const std::filesystem::path& file);

}  // namespace kerf
