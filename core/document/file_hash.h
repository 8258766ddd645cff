#pragma once

#include <cstdint>
#include <filesystem>

#include "core/base/progress.h"
#include "core/base/result.h"

namespace kerf {

// A number for the bytes of a regular file, by which a journal knows the mesh that it was made with. Not for
// keeping secrets. Reads the file once, a megabyte at a time. `progress` may be null.
Result<uint64_t> file_hash(const std::filesystem::path& file, const Progress* progress = nullptr);

}  // namespace kerf
