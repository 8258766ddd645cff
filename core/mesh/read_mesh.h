#pragma once

#include <filesystem>

#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/mesh/files/soup.h"

namespace kerf {

// Reads an OBJ, PLY, STL, OFF or glTF file. The content decides which format it is; the extension of the name
// is only a hint. Fails for anything but a regular file, for files of more than 4 GiB, and for errors of the
// format's reader, with one sentence that names the file and the line or byte; fails with cancelled() when
// stopped. `progress` may be null. Files may be read concurrently. The whole file is held in memory beside
// the result. Linear in its size.
Result<Soup> read_mesh(const std::filesystem::path& path, const Progress* progress = nullptr);

}  // namespace kerf
