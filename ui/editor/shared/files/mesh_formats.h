#pragma once

#include <filesystem>
#include <optional>
#include <span>

#include "core/mesh/files/mesh_format.h"

namespace kerf {

// A row with the formats in which meshes are written. Returns the one that was clicked, if any.
std::optional<MeshFormat> draw_mesh_formats(MeshFormat current);

// A line with the names of the files that an export writes, as many as fit.
void draw_file_names(std::span<const std::filesystem::path> files);

}  // namespace kerf
