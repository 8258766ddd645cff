#pragma once

#include <string>
#include <string_view>

#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/mesh/files/soup.h"

namespace kerf {

// Whether the first word of a file is a keyword of Geomview's OFF family, from OFF and COFF to STCN4nOFF. A
// digit may follow it directly, because files that lack the line break there are common.
bool is_off_keyword(std::string_view word);

// Reads OFF, COFF, NOFF, STOFF and their combinations in text form, with comments, and with the counts on the
// line of the keyword or on the next one. Positions, colours of vertices (see ColourNumbers) and faces are
// read; colours of faces, normals and texture coordinates are ignored. Binary OFF and OFF in four or n
// dimensions are refused. A face that refers to a missing vertex is dropped and counted. Linear in the number
// of bytes, except for large polygons (see Triangulator). `progress` may be null.
Result<Soup> read_off(std::string_view bytes, const std::string& file_name,
                      const Progress* progress = nullptr);

}  // namespace kerf
