#pragma once

#include <array>
#include <optional>
#include <string_view>
#include <vector>

#include "core/base/vec3.h"
#include "core/mesh/files/ply_header.h"
#include "core/mesh/files/soup.h"

namespace kerf {

// A fast way through large binary PLY files, for elements of the usual kind whose rows all have the same
// number of bytes. Where the rows are of another kind, nothing is returned and the general reader must be
// used.

// A column of values and the number of bytes that it takes.
template <typename T>
struct PlyRows {
  std::vector<T> values;
  size_t bytes = 0;
};

// The places of red, green, blue and opacity among the properties of a vertex. Nothing if one of the first
// three is missing; the last one may be, and is kNoProperty then. Opacity is called alpha, and a name may
// start with "diffuse_".
inline constexpr size_t kNoProperty = ~size_t{0};
std::optional<std::array<size_t, 4>> colour_properties_of(const PlyElement& element);

// Positions from little-endian rows of scalars; `bytes` starts at the first row. x, y and z must all be
// floats or all doubles, and colours numbers of eight bits. On several threads.
struct PlyVertices {
  std::vector<Vec3> positions;
  std::vector<VertexColour> colours;  // one per position, or empty if there are none
};
struct PlyVertexRows {
  PlyVertices values;
  size_t bytes = 0;
};
std::optional<PlyVertexRows> read_vertex_rows(const PlyElement& element, std::string_view bytes);

// Triangles from little-endian rows with one list, whose length is a uchar and is 3 in every row and whose
// corners are ints. A corner that is no index becomes one that is out of range. On several threads.
std::optional<PlyRows<Soup::Triangle>> read_triangle_rows(const PlyElement& element, std::string_view bytes);

}  // namespace kerf
