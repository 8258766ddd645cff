#pragma once

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

// Positions from little-endian rows of scalars; `bytes` starts at the first row. x, y and z must all be
// floats or all doubles. On several threads.
std::optional<PlyRows<Vec3>> read_position_rows(const PlyElement& element, std::string_view bytes);

// Triangles from little-endian rows with one list, whose length is a uchar and is 3 in every row and whose
// corners are ints. A corner that is no index becomes one that is out of range. On several threads.
std::optional<PlyRows<Soup::Triangle>> read_triangle_rows(const PlyElement& element, std::string_view bytes);

}  // namespace kerf
