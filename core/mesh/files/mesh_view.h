#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string>

#include "core/base/vec3.h"

namespace kerf {

// A triangle mesh to be written: looked at, not owned.
struct MeshView {
  std::span<const Vec3> positions;                     // finite
  std::span<const std::array<uint32_t, 3>> triangles;  // indices of positions, counter-clockwise
  std::span<const uint16_t> materials;                 // one a triangle, or empty
  std::span<const std::string> material_names;         // of every material that a triangle has
};

}  // namespace kerf
