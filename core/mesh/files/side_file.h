#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <string_view>

#include "core/base/result.h"

namespace kerf {

// Returns the last component of a path with slashes or backslashes.
std::string side_file_name(std::string_view reference);

// Reads a file that a mesh file refers to, e.g. an image. Only files in `folder` and below are read: if the
// reference is absolute, leads out of the folder or names no regular file, the file of the same name in
// `folder` is read instead. Fails if there is no such file, or if it has more than `max_bytes` bytes; the
// message is a predicate, to which the caller adds the file name.
Result<std::string> read_side_file(const std::filesystem::path& folder, std::string_view reference,
                                   size_t max_bytes);

}  // namespace kerf
