#pragma once

#include <filesystem>

#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/mesh/build_mesh.h"

namespace kerf {

// Reads a mesh file and builds its mesh (read_mesh, then build_mesh); every failure names the file, but for
// cancelled(). `progress` may be null.
Result<BuiltMesh> load_mesh(const std::filesystem::path& file, const Progress* progress);

}  // namespace kerf
