#pragma once

#include <filesystem>

#include "core/base/result.h"
#include "core/mesh/build_mesh.h"

namespace kerf {

// Reads a mesh file and builds its mesh, showing a ProgressLine. Fails with an error that names the file, or
// with stopped() after Ctrl-C.
Result<BuiltMesh> load_mesh(const std::filesystem::path& file);

}  // namespace kerf
