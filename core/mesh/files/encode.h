#pragma once

#include <string>

#include "core/mesh/files/mesh_view.h"

namespace kerf {

// A mesh as the bytes of a file. Positions and triangles keep their order and read back bit-equal, but from
// STL, which holds positions as floats, three a triangle. Linear.

// OBJ with the shortest numbers that read back as they were, and a usemtl wherever the material changes.
std::string encode_obj(const MeshView& mesh);
// OFF with the same numbers; no materials.
std::string encode_off(const MeshView& mesh);
// Little-endian binary PLY, positions in double; no materials. At most 2^31 positions.
std::string encode_ply(const MeshView& mesh);
// Binary STL, positions rounded to float, which they must fit; normals of the triangles as written; no
// materials. At most 2^32 - 1 triangles.
std::string encode_stl(const MeshView& mesh);

}  // namespace kerf
