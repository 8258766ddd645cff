#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "core/base/vec3.h"

namespace kerf {

// Linear RGB (0 .. 1) from "#rrggbb" (sRGB); empty for anything else.
std::optional<Vec3> parse_colour(std::string_view text);

// The nearest such text; what parse_colour gave comes back as it was, in lower case.
std::string colour_text(const Vec3& linear);

}  // namespace kerf
