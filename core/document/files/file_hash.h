#pragma once

#include <cstdint>
#include <filesystem>

#include "core/base/progress.h"
#include "core/base/result.h"

namespace kerf {

// A hash of the bytes of a regular file, by which a journal identifies its meshes. It is not cryptographic.
// Fails if the file cannot be read, or with cancelled() when stopped; `progress` may be null. Reads the file
// once, in blocks of a megabyte. Linear time.
Result<uint64_t> file_hash(const std::filesystem::path& file, const Progress* progress = nullptr);

}  // namespace kerf
