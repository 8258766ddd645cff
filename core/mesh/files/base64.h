#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace kerf {

// Bytes as text in base 64 (RFC 4648), with padding.
std::string to_base64(std::string_view bytes);

// The bytes of such a text, whose padding may be missing; nothing if it is none.
std::optional<std::string> from_base64(std::string_view text);

}  // namespace kerf
