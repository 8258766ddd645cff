#pragma once

#include <string>
#include <string_view>

#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/mesh/files/soup.h"

namespace kerf {

// Whether the bytes are exactly as long as a binary STL file with the number of triangles that they announce.
// No text of less than 8 GiB satisfies this.
bool is_exact_binary_stl(std::string_view bytes);

// Reads an STL file, binary or text: it is text if it starts with "solid" and contains no zero byte. The
// result has three positions per triangle, which are not welded. Normals and attributes are ignored, keywords
// may be in upper or lower case, and several solids are joined into one soup. Bytes after the last triangle
// of a binary file give a warning. Linear in the number of bytes. `progress` may be null.
Result<Soup> read_stl(std::string_view bytes, const std::string& file_name,
                      const Progress* progress = nullptr);

}  // namespace kerf
