#pragma once

#include <filesystem>

#include "core/base/result.h"
#include "core/mesh/files/encode.h"

namespace kerf {

// Writes a mesh: OBJ and OFF as text, PLY, STL and GLB in binary. Positions are read back to the bit and
// triangles in the same order, except that STL stores positions in single precision and no shared vertices,
// and glTF positions in single precision relative to the middle of the mesh and triangles by material; OBJ
// and glTF store the names of materials. The file is written whole or not at all (see write_file_atomically).
// Fails with one sentence if it cannot be written or if the format cannot represent the mesh, e.g.
// coordinates beyond the range of float in STL. All bytes are held in memory before they are written. Linear
// time.
Status write_mesh(const MeshView& mesh, const std::filesystem::path& path, MeshFormat format);

}  // namespace kerf
