#pragma once

#include <string>

#include "core/base/result.h"
#include "core/base/vec3.h"

namespace kerf {

// The size of a picture in pixels.
struct PixelSize {
  int width = 0, height = 0;
};

// Parses "WxH", each number from 1 to 16384.
Result<PixelSize> parse_size(const std::string& text);

// Parses "x,y,z", three finite numbers. The error names `option`.
Result<Vec3> parse_point(const std::string& option, const std::string& text);

// Parses a text that consists of one finite number. Returns false for any other text.
bool parse_number(std::string_view text, double& value);

}  // namespace kerf
