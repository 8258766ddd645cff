#pragma once

#include <string>
#include <string_view>

#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/mesh/soup.h"

namespace kerf {

// Reads PLY as text and in both binary orders: elements and properties in any order, any type of numbers,
// lists beside the indices. x, y and z of "vertex" are the positions; the list vertex_indices (or
// vertex_index) of "face" are polygons, that of "tristrips" triangle strips, ended by an index of -1, each
// triangle of which counts as a face. All else is passed over. A face that names a vertex that is not there
// is dropped and counted. Linear in the bytes, but for polygons (see Triangulator).
Result<Soup> read_ply(std::string_view bytes, const std::string& file_name,
                      const Progress* progress = nullptr);

}  // namespace kerf
