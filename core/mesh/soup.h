#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "core/base/vec3.h"

namespace kerf {

// What a mesh file holds, before anything is welded or judged: polygons already cut into triangles, positions
// as read. Corners may be equal, indices are all in range, positions may be non-finite (their faces are
// counted and dropped by build_mesh).
struct Soup {
  using Triangle = std::array<uint32_t, 3>;  // indices into positions, counter-clockwise seen from outside

  std::vector<Vec3> positions;  // metres, in the frame of the file
  std::vector<Triangle> triangles;
  std::vector<uint16_t> materials;  // one a triangle: index into material_names; empty when there is one
  std::vector<std::string> material_names;  // as the file names them ("usemtl")

  std::string format;                 // "obj", "off", "stl", "ply"
  size_t faces_in_file = 0;           // polygons as the file lists them
  size_t triangles_in_file = 0;       // n - 2 for a polygon of n corners, invalid ones too
  size_t invalid_faces_dropped = 0;   // triangles of polygons with an index that is not there
  std::vector<std::string> warnings;  // one sentence each, for people
};

}  // namespace kerf
