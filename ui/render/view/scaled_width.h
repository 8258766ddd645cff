#pragma once

#include <algorithm>

namespace kerf {

inline constexpr float kUsualHeight = 900;  // of a picture, pixels; line.glsl says it too

// The width in pixels of a line that is so wide in a picture of the usual height or less, in one of this
// height.
inline float scaled_width(float width, int height) {
  return width * std::max(1.0f, static_cast<float>(height) / kUsualHeight);
}

}  // namespace kerf
