#pragma once

#include <filesystem>

#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/mesh/soup.h"

namespace kerf {

// Reads an OBJ, PLY, STL or OFF file. The content decides which it is; the ending of the name is only a hint.
// Refused, in one sentence that names the file and the line or byte: what is no regular file, what is larger
// than 4 GiB, and what the readers call fatal. Any number of files may be read at the same time. The whole
// file is held in memory beside the result. Linear in its size.
Result<Soup> read_mesh(const std::filesystem::path& path, const Progress* progress = nullptr);

}  // namespace kerf
