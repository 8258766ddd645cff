#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace kerf {

// The text of a hash in files and reports: sixteen lower-case hexadecimal digits.
std::string hash_text(uint64_t hash);

// Parses that text. Returns nothing for any other text.
std::optional<uint64_t> parse_hash(std::string_view text);
// The rule that an error states about a text that is no hash.
inline constexpr const char* kHashRule = "must be sixteen hexadecimal digits";

}  // namespace kerf
