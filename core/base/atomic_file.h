#pragma once

#include <filesystem>
#include <functional>
#include <string_view>

#include "core/base/byte_sink.h"
#include "core/base/result.h"

namespace kerf {

// Writes a whole file or leaves the previous contents untouched: the bytes go to a temporary file in the
// target's directory, which is flushed to the disk and renamed over the target. A symbolic link is followed,
// and a replaced file keeps its permissions. A device or a pipe (/dev/stdout) is written to directly. On
// failure the temporary file is removed, and the error is one sentence that names the target.
Status write_file_atomically(const std::filesystem::path& path, std::string_view bytes);

// Writes a file like that from bytes that come in parts. `produce` hands the parts to the sink and returns
// early where the sink returns false. An exception of `produce` is passed on, and leaves no temporary file.
Status write_file_atomically(const std::filesystem::path& path,
                             const std::function<void(const ByteSink&)>& produce);

// Writes all of the bytes to an open file. Returns the error number, or 0.
int write_all(int file, std::string_view bytes);

}  // namespace kerf
