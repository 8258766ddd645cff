#pragma once

#include <filesystem>

#include "ui/editor/view/piece_set.h"

namespace kerf {

// Inserts a number into a file name: "piece.obj" becomes "piece-2.obj".
std::filesystem::path numbered(const std::filesystem::path& file, size_t number);

// Writes the chosen pieces of a world where they stand, in the format that the ending of the file's name
// says: one piece to the file itself, several to numbered files beside it. Returns how many were written;
// what was written before a failure stays.
Result<size_t> export_chosen(const World& world, const PieceMap& looks, const std::filesystem::path& file);

}  // namespace kerf
