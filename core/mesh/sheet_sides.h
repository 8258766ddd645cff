#pragma once

#include <cstdint>
#include <vector>

#include "core/mesh/mesh.h"

namespace kerf {

// The boundaries of single sheets of a mesh. Mesh::append_open_sides omits boundaries that touch other
// sheets, i.e. whose edges are in rings.

// A side on the boundary of a sheet, and whether its edge is in a ring.
struct SheetSide {
  Mesh::Side side;
  bool is_shared;
};

// Append the sides on boundaries of sheets: those of a live face, and those along the edges in slots first ..
// end - 1, which may exceed edge_slots(). Linear in the edges.
void append_sheet_sides_of(const Mesh& mesh, FaceId f, std::vector<SheetSide>& out);
void append_sheet_sides_in(const Mesh& mesh, uint32_t first, uint32_t end, std::vector<SheetSide>& out);

// Appends the neighbours of a live face on its sheet: the other face on each edge, excluding those over
// rings.
void append_sheet_neighbours(const Mesh& mesh, FaceId f, std::vector<FaceId>& out);

}  // namespace kerf
