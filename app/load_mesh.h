#pragma once

#include <filesystem>

#include "core/base/result.h"
#include "core/mesh/build_mesh.h"

namespace kerf {

// Reads a mesh file and builds its mesh; a failure names the file. Shows a ProgressLine and stops at Ctrl-C.
Result<BuiltMesh> load_mesh(const std::filesystem::path& file);

}  // namespace kerf
