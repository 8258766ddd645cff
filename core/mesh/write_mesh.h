#pragma once

#include <filesystem>

#include "core/base/result.h"
#include "core/mesh/files/mesh_format.h"
#include "core/mesh/files/mesh_view.h"

namespace kerf {

// Writes a mesh: OBJ and OFF as text, PLY and STL in binary. Positions read back bit-equal and triangles in
// the same order, but STL holds positions as floats and no vertices to share; only OBJ holds materials. The
// file is written whole or not at all (see write_file_atomically). Fails in one sentence when it cannot be
// written, or when the format cannot hold the mesh: for STL, coordinates beyond the range of float. The bytes
// are held in memory before they are written.
Status write_mesh(const MeshView& mesh, const std::filesystem::path& path, MeshFormat format);

}  // namespace kerf
