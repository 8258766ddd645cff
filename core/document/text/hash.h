#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

#include "core/base/parallel.h"
#include "core/base/result.h"

namespace kerf {

// Hashes the bytes of a regular file; journals identify their meshes by this hash. Not cryptographic. Fails
// if the file cannot be read, or with cancelled() when stopped; `progress` may be null. Reads the file once,
// in blocks of a megabyte. Linear time.
Result<uint64_t> file_hash(const std::filesystem::path& file, const Progress* progress = nullptr);

// Formats a hash for files and reports: sixteen lower-case hexadecimal digits.
std::string hash_text(uint64_t hash);

// Parses a text of hash_text(), in either case. Returns nullopt for any other text.
std::optional<uint64_t> parse_hash(std::string_view text);
// The rule stated in errors.
inline constexpr const char* kHashRule = "must be sixteen hexadecimal digits";

}  // namespace kerf
