#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "core/base/vec3.h"
#include "core/mesh/files/vertex_colour.h"

namespace kerf {

// A part that a file names, as OBJ does its objects and groups: a range of triangles, or of faces.
struct MeshPart {
  std::string name;
  uint32_t first = 0, last = 0;  // from the first one up to, but not including, the last one
};

// The content of a mesh file before welding and validation: its polygons cut into triangles, and positions as
// read. All indices are in range. The corners of a triangle may be equal, and positions may be non-finite;
// build_mesh drops and counts such faces.
struct Soup {
  using Triangle = std::array<uint32_t, 3>;  // indices into positions, counter-clockwise seen from outside

  std::vector<Vec3> positions;        // metres, in the frame of the file
  std::vector<VertexColour> colours;  // one per position, or empty if the file has none
  std::vector<Triangle> triangles;
  std::vector<uint16_t> materials;          // one per triangle: index into material_names; empty if all are 0
  std::vector<std::string> material_names;  // as in the file ("usemtl")
  std::vector<MeshPart> parts;  // of triangles, none empty; ranges may overlap and names may repeat

  std::string format;                 // "obj", "off", "stl", "ply", "glb", "gltf"
  size_t faces_in_file = 0;           // polygons
  size_t triangles_in_file = 0;       // n - 2 for a polygon of n corners, including invalid ones
  size_t invalid_faces_dropped = 0;   // triangles of polygons that refer to a missing vertex
  std::vector<std::string> warnings;  // one sentence each, for the user
};

}  // namespace kerf
