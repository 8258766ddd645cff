#pragma once

#include <string>

#include "core/base/result.h"
#include "core/base/vec3.h"

namespace kerf {

struct PixelSize {
  int width = 0, height = 0;
};

// "WxH", each from 1 to 16384.
Result<PixelSize> parse_size(const std::string& text);

// "x,y,z", three finite numbers; `option` is what the sentence names.
Result<Vec3> parse_point(const std::string& option, const std::string& text);

// A finite number that is the whole of the text.
bool parse_number(std::string_view text, double& value);

}  // namespace kerf
