#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "core/base/vec3.h"

namespace kerf {

// Converts "#rrggbb" (sRGB) to linear RGB in 0 .. 1. Returns nothing for any other text.
std::optional<Vec3> parse_colour(std::string_view text);

// Converts linear RGB to the nearest "#rrggbb". A colour that parse_colour returned is converted back to its
// text in lower case.
std::string colour_text(const Vec3& linear);

}  // namespace kerf
