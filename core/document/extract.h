#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "core/world/mass_properties.h"
#include "core/world/world.h"

namespace kerf {

// A copy of some faces of a body as plain arrays in world coordinates, exact to the bit if the body was not
// moved. Coincident vertices are merged; vertices and faces keep the order of their slots.
struct Extract {
  std::vector<Vec3> positions;
  std::vector<std::array<uint32_t, 3>> triangles;
  std::vector<uint16_t> materials;    // one per triangle, or empty if the body has none
  std::vector<VertexColour> colours;  // one per position, or empty if the body has none
  double area = 0;                    // m^2
  Vec3 centroid{0};                   // centre of area, or of volume if solid, m
  size_t boundary_edges = 0;          // edges with one face
  std::optional<double> volume;       // enclosed by the faces, m^3; nullopt if they are not closed
  bool solid = false;                 // the faces are of a solid body and enclose a volume
};

// Copies faces. Precondition: they are live and ascending. O(n log n).
Extract extract_faces(const Body& body, std::span<const FaceId> faces);

// The mass properties of an extract, as a solid if it is one and otherwise as a sheet, about its centroid,
// in world axes. O(n).
MassProperties mass_of(const Extract& extract, const Sheet& sheet);

// The live faces of each piece of a body that has any, in the order of labels; with `every_component`,
// those of each connected component, in the order of their lowest faces. O(n).
std::vector<std::vector<FaceId>> faces_by_piece(const Body& body, bool every_component);

}  // namespace kerf
