#pragma once

#include <filesystem>

#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/mesh/build_mesh.h"

namespace kerf {

// Reads a mesh file with read_mesh and builds its mesh with build_mesh. The message of every failure but
// cancelled() names the file. `progress` may be null.
Result<BuiltMesh> load_mesh(const std::filesystem::path& file, const Progress* progress);

}  // namespace kerf
