#pragma once

#include <filesystem>
#include <string_view>

#include "core/base/result.h"

namespace kerf {

// Writes a whole file or leaves the previous contents untouched: the bytes go to a temporary file in the
// target's directory, which is flushed to the disk and renamed over the target. A symbolic link is followed,
// and a replaced file keeps its permissions. A device or a pipe (/dev/stdout) is written to directly. On
// failure the temporary file is removed, and the error is one sentence that names the target.
Status write_file_atomically(const std::filesystem::path& path, std::string_view bytes);

}  // namespace kerf
