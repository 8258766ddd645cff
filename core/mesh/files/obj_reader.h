#pragma once

#include <string>
#include <string_view>

#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/mesh/soup.h"

namespace kerf {

// Reads Wavefront OBJ: v, f and usemtl; indices from the start or, negative, from the end. Groups, normals,
// texture coordinates, vertex colours and material libraries are passed over, points, lines and free-form
// geometry with a warning. A face that names a vertex that is not there is dropped and counted; a word where
// a number must be is an error. Linear in the bytes, but for polygons (see Triangulator).
Result<Soup> read_obj(std::string_view bytes, const std::string& file_name,
                      const Progress* progress = nullptr);

}  // namespace kerf
