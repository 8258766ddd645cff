#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "core/world/world.h"

namespace kerf {

// Some faces of a body as a mesh of their own, in world coordinates, bit-equal where the body was not moved:
// equal positions welded, vertices and faces in the order of their slots.
struct Extract {
  std::vector<Vec3> positions;
  std::vector<std::array<uint32_t, 3>> triangles;
  std::vector<uint16_t> materials;  // one a triangle, or empty where the body names none
  double area = 0;                  // m^2
  Vec3 centroid{0};                 // of the area
  size_t boundary_edges = 0;        // edges with one face
};

// faces are live and ascending. O(n log n).
Extract extract_faces(const Body& body, std::span<const FaceId> faces);

// The live faces of each piece of a body that has any, by label; or with `every_component` of each set that
// hangs together over edges, by lowest face.
std::vector<std::vector<FaceId>> faces_by_piece(const Body& body, bool every_component);

}  // namespace kerf
