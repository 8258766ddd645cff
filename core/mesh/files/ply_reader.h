#pragma once

#include <string>
#include <string_view>

#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/mesh/files/soup.h"

namespace kerf {

// Reads a PLY file, as text or binary in either byte order, with elements and properties in any order and of
// any type. The properties x, y and z of "vertex" give positions. The list vertex_indices (or vertex_index)
// of "face" gives a polygon; that of "tristrips" gives triangle strips, each ended by an index of -1, whose
// triangles count as faces. Everything else is ignored. A face that refers to a missing vertex is dropped and
// counted. Linear in the number of bytes, except for large polygons (see Triangulator). `progress` may be
// null.
Result<Soup> read_ply(std::string_view bytes, const std::string& file_name,
                      const Progress* progress = nullptr);

}  // namespace kerf
