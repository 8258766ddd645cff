#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/mesh/files/gltf_file_internal.h"
#include "core/mesh/files/surfaces.h"

namespace kerf {

// Returns true if values are nested at most this deep. Writing JSON takes stack memory for each level.
bool is_shallow(const nlohmann::json& json, int depth = 32);

// Reads materials of a glTF file (nullopt: one that only has a number), with all textures, samplers and
// images. Images in other files are read from `folder` (see read_side_file). Appends warnings about images
// that are missing and about materials that are nested too deeply. Returns null if there is no material.
std::shared_ptr<const SurfaceLibrary> read_gltf_surfaces(const GltfFile& file,
                                                         std::span<const std::optional<uint32_t>> materials,
                                                         const std::filesystem::path& folder,
                                                         std::vector<std::string>& warnings);

}  // namespace kerf
