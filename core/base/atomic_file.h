#pragma once

#include <filesystem>
#include <string_view>

#include "core/base/result.h"

namespace kerf {

// Writes a whole file or leaves what was there: the bytes go to a temporary file beside the target, are
// flushed to the disk and renamed over it. A link is followed, and the permissions of a file that is replaced
// are kept. A device or a pipe (/dev/stdout) is written to as it is. On failure the temporary file is gone
// and the error is one sentence that names the target.
Status write_file_atomically(const std::filesystem::path& path, std::string_view bytes);

}  // namespace kerf
