#pragma once

#include <string>

#include "core/mesh/files/mesh_view.h"

namespace kerf {

// Encodes a mesh as the bytes of a file. Positions and triangles keep their order and are read back to the
// bit, except from STL, which stores three positions in single precision per triangle. Precondition: the mesh
// satisfies the requirements stated at MeshView. Linear time.

// OBJ with the shortest decimal numbers that are read back exactly, a mtllib if the mesh has a library, and a
// usemtl wherever the material changes.
std::string encode_obj(const MeshView& mesh);
// OFF with numbers of the same kind; without materials.
std::string encode_off(const MeshView& mesh);
// Little-endian binary PLY with positions in double precision; without materials. Precondition: there are at
// most 2^31 positions.
std::string encode_ply(const MeshView& mesh);
// Binary STL with positions rounded to single precision and unit normals computed from the corners; without
// materials. Preconditions: positions are within the range of float, and there are fewer than 2^32 triangles.
std::string encode_stl(const MeshView& mesh);

}  // namespace kerf
