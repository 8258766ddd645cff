#pragma once

#include <string>
#include <string_view>

#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/mesh/soup.h"

namespace kerf {

// Whether the bytes are as long as the count in them says of a binary STL. No text of less than 8 GiB is.
bool is_exact_binary_stl(std::string_view bytes);

// Reads STL, binary or as text, whichever it is: a file that begins with "solid" and has no zero byte is
// text. Three positions a triangle, not welded. Normals and attributes are passed over, keywords may be in
// any case, several solids make one soup. Bytes after the last triangle of a binary file are a warning.
// Linear.
Result<Soup> read_stl(std::string_view bytes, const std::string& file_name,
                      const Progress* progress = nullptr);

}  // namespace kerf
