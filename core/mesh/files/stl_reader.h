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

// Reads an STL file, binary or text: it is text if it starts with "solid" or "facet" and contains no zero
// byte. The result has three positions per triangle, which are not welded. Normals and attributes are
// ignored, and several solids are joined into one soup. Keywords may be in upper or lower case. With a
// warning, text may have "end loop" or "end facet", solids that are not ended or ended twice, "endsolidNAME",
// and further lines between facets; a facet itself must be whole. A binary file whose number of triangles is
// wrong is read by its size, with a warning, if that is a number of whole triangles whose corners are finite;
// other bytes after the last triangle are passed over with a warning. Linear in the number of bytes.
// `progress` may be null.
Result<Soup> read_stl(std::string_view bytes, const std::string& file_name,
                      const Progress* progress = nullptr);

}  // namespace kerf
