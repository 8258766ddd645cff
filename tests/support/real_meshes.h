#pragma once

#include <filesystem>
#include <vector>

#include "core/world/world.h"

namespace kerf::test {

inline constexpr const char* kNoRealMeshes = "KERF_TEST_MESHES names no folder with real meshes";

// Mesh files under $KERF_TEST_MESHES/real that can be read and have no more faces than this, sorted: every
// third one, or all of them where runs() tries all. Empty where the folder is not there.
std::vector<std::filesystem::path> real_meshes(size_t max_faces);

// A world of the one body in the file.
World world_of_file(const std::filesystem::path& file);

}  // namespace kerf::test
