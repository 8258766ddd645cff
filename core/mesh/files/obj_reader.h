#pragma once

#include <string>
#include <string_view>

#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/mesh/files/soup.h"

namespace kerf {

// Reads a Wavefront OBJ file: the statements v, f and usemtl, with indices that count from the first vertex
// or, if negative, back from the last one. Objects and groups become parts. Normals, texture coordinates and
// material libraries are ignored; points, lines and free-form geometry are ignored with a warning. As in
// common readers, '#' begins a comment at the start of a line and after numbers, but belongs to the names of
// o, g and usemtl, which end with their line. Colours of vertices are numbers to 1 or to 255 (see
// ColourNumbers). A face that refers to a missing vertex is dropped and counted.
// Anything but a number where one is required is an error. Linear in the number of bytes, except for large
// polygons (see Triangulator). `progress` may be null.
Result<Soup> read_obj(std::string_view bytes, const std::string& file_name,
                      const Progress* progress = nullptr);

}  // namespace kerf
