#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace kerf {

// A hash as files and reports show it: sixteen lower-case hexadecimal digits.
std::string hash_text(uint64_t hash);

// Takes exactly that; empty for anything else.
std::optional<uint64_t> parse_hash(std::string_view text);

}  // namespace kerf
