#pragma once

#include <string>
#include <string_view>

#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/mesh/files/soup.h"

namespace kerf {

// Reads a Wavefront OBJ file: the statements v, f and usemtl, with indices that count from the first vertex
// or, if negative, back from the last one. Groups, normals, texture coordinates, vertex colours and material
// libraries are ignored; points, lines and free-form geometry are ignored with a warning. A face that refers
// to a missing vertex is dropped and counted. Anything but a number where one is required is an error. Linear
// in the number of bytes, except for large polygons (see Triangulator). `progress` may be null.
Result<Soup> read_obj(std::string_view bytes, const std::string& file_name,
                      const Progress* progress = nullptr);

}  // namespace kerf
