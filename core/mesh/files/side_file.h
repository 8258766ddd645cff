#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

#include "core/base/result.h"

namespace kerf {

// Returns the last component of a path with slashes or backslashes.
std::string side_file_name(std::string_view reference);

// Returns the path of a file that a mesh file in `folder` refers to, e.g. an image. It lies in the folder or
// below: if the reference is absolute, leads out of the folder or names no regular file, it is that of the
// same name in `folder`, which need not exist. Returns nullopt if the reference names no file.
std::optional<std::filesystem::path> side_file(const std::filesystem::path& folder,
                                               std::string_view reference);

// Reads the file of side_file(). Fails if there is no such file, or if it has more than `max_bytes` bytes;
// the message is a predicate, to which the caller adds the file name.
Result<std::string> read_side_file(const std::filesystem::path& folder, std::string_view reference,
                                   size_t max_bytes);

}  // namespace kerf
