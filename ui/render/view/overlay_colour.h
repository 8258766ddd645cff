#pragma once

#include <cstdint>
#include <glm/vec4.hpp>

namespace kerf {

// The colour 0xRRGGBB in sRGB with an opacity from 0 to 1.
inline glm::vec4 srgb(uint32_t hex, float opacity = 1) {
  const auto part = [&](int shift) { return static_cast<float>(hex >> shift & 0xffu) / 255.0f; };
  return {part(16), part(8), part(0), opacity};
}

// A line is drawn as two triangles.
inline constexpr int kVerticesOfLine = 6;

}  // namespace kerf
